d = abs(xn - x1)
d = scale(d, -exponent(maxval(d)))
more = merge(3, 2, d(3) >= d(2))
less = 5 - more
axes = [less, more, 1]
if (d(more) > 0 .and. d(more)**2 + d(less)**2 >= d(more) * d(1)) axes = [less, 1, more]
