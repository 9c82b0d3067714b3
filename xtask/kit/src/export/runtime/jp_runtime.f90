! What the formulas call: lengths that neither overflow nor underflow, sums of products that lose
! nothing, the closest place of a curve. Printed by jointproof; free of conditions (CC0-1.0).
module jp_runtime
    use, intrinsic :: iso_c_binding, only: c_double
    use, intrinsic :: iso_fortran_env, only: int64, dp => real64
    use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
    implicit none
    public

    interface
        pure function jp_fma(x, y, z) bind(c, name='fma') result(w)
            import :: c_double
            real(c_double), value :: x, y, z
            real(c_double) :: w
        end function jp_fma
        pure function jp_library_expm1(x) bind(c, name='expm1') result(w)
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: w
        end function jp_library_expm1
    end interface

    ! An exact sum: parts that do not overlap, smaller ones first, none of them 0 (Shewchuk).
    type :: jp_expansion
        real(dp) :: part(144)
        integer :: n = 0
    end type jp_expansion

contains

    pure function jp_infinity() result(x)
        real(dp) :: x
        x = ieee_value(0.0_dp, ieee_positive_inf)
    end function jp_infinity

    ! Equality, spelt so that no compiler warns of it: here it is meant.
    pure function jp_equal(x, y) result(equal)
        real(dp), intent(in) :: x, y
        logical :: equal
        equal = x <= y .and. x >= y
    end function jp_equal

    ! The root of a sum of squares, rescaled where that would leave the range of doubles.
    pure function jp_norm(x) result(length)
        real(dp), intent(in) :: x(:)
        real(dp) :: length, total, factor
        integer :: k
        total = 0.0_dp
        do k = 1, size(x)
            total = total + x(k)*x(k)
        end do
        length = sqrt(total)
        if (total > 2.0_dp**(-900) .and. total < 2.0_dp**1000) return
        factor = 2.0_dp**600
        if (any(abs(x) > 1.0_dp)) factor = 2.0_dp**(-600)
        total = 0.0_dp
        do k = 1, size(x)
            total = total + (x(k)*factor)*(x(k)*factor)
        end do
        length = sqrt(total)/factor
    end function jp_norm

    pure function jp_norm2(x, y) result(length)
        real(dp), intent(in) :: x, y
        real(dp) :: length
        length = jp_norm([x, y])
    end function jp_norm2

    pure function jp_norm3(x, y, z) result(length)
        real(dp), intent(in) :: x, y, z
        real(dp) :: length
        length = jp_norm([x, y, z])
    end function jp_norm3

    pure function jp_norm4(x, y, z, w) result(length)
        real(dp), intent(in) :: x, y, z, w
        real(dp) :: length
        length = jp_norm([x, y, z, w])
    end function jp_norm4

    ! z P(z), in parts that do not wait for each other.
    pure function jp_beyond(p, z) result(beyond)
        real(dp), intent(in) :: p(0:11), z
        real(dp) :: beyond, z2, z4
        z2 = z*z
        z4 = z2*z2
        beyond = ((p(4) + p(5)*z) + (p(6) + p(7)*z)*z2)*z4
        beyond = ((p(0) + p(1)*z) + (p(2) + p(3)*z)*z2) + beyond
        beyond = z*(beyond + ((p(8) + p(9)*z) + (p(10) + p(11)*z)*z2)*(z4*z4))
    end function jp_beyond

    ! The angle of (x, y): beside the nearest sixteenth of a turn the arc tangent is a polynomial.
    pure function jp_angle(y, x) result(turn)
        real(dp), intent(in) :: y, x
        real(dp) :: turn, across, along, large, small, steep, back, wide, t, rest, way, eighths, low
        real(dp), parameter :: p(0:11) = [ &
            -0.3333333333333333_dp, 0.19999999999999804_dp, -0.1428571428565978_dp, &
            0.11111111105150588_dp, -0.09090908753259112_dp, 0.07692296368042296_dp, &
            -0.0666642476020052_dp, 0.05878927554473807_dp, -0.05230443640686948_dp, &
            0.045515447340221615_dp, -0.03456931506332609_dp, 0.016284375050043393_dp]
        across = abs(y)
        along = abs(x)
        large = merge(across, along, across > along)
        small = merge(along, across, along < across)
        if (.not. (large > 0.0_dp .and. large < 1e300_dp)) then
            turn = atan2(y, x)
            return
        end if
        steep = merge(1.0_dp, 0.0_dp, across > along)
        back = merge(1.0_dp, 0.0_dp, x < 0.0_dp)
        wide = merge(1.0_dp, 0.0_dp, small > 0.41421356237309503_dp*large)
        t = (small - large*wide)/(large + small*wide)
        rest = t*jp_beyond(p, t*t)
        way = (1.0_dp - 2.0_dp*steep)*(1.0_dp - 2.0_dp*back)
        eighths = (2.0_dp*steep + (4.0_dp*back)*(1.0_dp - steep)) + way*wide
        low = (way*eighths)*3.061616997868383e-17_dp
        turn = sign(eighths*0.7853981633974483_dp + way*(t + (rest + low)), y)
    end function jp_angle

    ! The arc sine: up to 1/2 a polynomial, beyond what twice another one leaves of a quarter turn.
    pure function jp_asin(x) result(angle)
        real(dp), intent(in) :: x
        real(dp) :: angle, size, z, s, turn, way, rest, total, lost
        logical :: wide
        real(dp), parameter :: p(0:11) = [ &
            0.16666666666665653_dp, 0.0750000000029469_dp, 0.04464285685604654_dp, &
            0.030381958187905646_dp, 0.022371777525770062_dp, 0.017359447897278054_dp, &
            0.013887491270956195_dp, 0.012155871500411723_dp, 0.006580488107098665_dp, &
            0.01939632260033307_dp, -0.016032766254421116_dp, 0.03179011988382487_dp]
        size = abs(x)
        wide = size > 0.5_dp
        z = merge((1.0_dp - size)*0.5_dp, size*size, wide)
        s = merge(sqrt(z), size, wide)
        turn = merge(1.5707963267948966_dp, 0.0_dp, wide)
        way = merge(-2.0_dp, 1.0_dp, wide)
        rest = s*jp_beyond(p, z) - merge(3.061616997868383e-17_dp, 0.0_dp, wide)
        total = turn + way*s
        lost = (turn - total) + way*s
        angle = sign(total + (lost + way*rest), x)
    end function jp_asin

    ! e**x - 1: with x = k ln 2 + r it is 2**k (e**r - 1) + (2**k - 1).
    pure function jp_expm1(x) result(grown)
        real(dp), intent(in) :: x
        real(dp) :: grown, k, above, below, r, power, total
        real(dp), parameter :: whole = 6755399441055744.0_dp, p(0:11) = [ &
            0.5_dp, 0.16666666666666666_dp, 0.04166666666666667_dp, 0.008333333333333333_dp, &
            0.0013888888888883748_dp, 0.00019841269841266415_dp, 2.4801587325547743e-05_dp, &
            2.7557319239957097e-06_dp, 2.75572736431103e-07_dp, 2.5052078002329456e-08_dp, &
            2.0914686968086876e-09_dp, 1.6084327883952603e-10_dp]
        if (.not. (abs(x) > 1e-300_dp .and. abs(x) < 700.0_dp)) then
            grown = jp_library_expm1(x)
            return
        end if
        k = (x*1.4426950408889634_dp + whole) - whole
        above = x - k*0.6931471803691238_dp
        below = k*1.9082149292705877e-10_dp
        r = above - below
        power = scale(1.0_dp, int(k))
        total = (power - 1.0_dp) + power*r
        grown = power*((above - r) - below) + (((power - 1.0_dp) - total) + power*r)
        grown = total + (power*r*jp_beyond(p, r) + grown)
    end function jp_expm1

    ! The largest power of two that is not above a positive number, within 2**(-1022) and 2**1022.
    pure function jp_power_of_two(x) result(power)
        real(dp), intent(in) :: x
        real(dp) :: power
        power = scale(1.0_dp, min(exponent(x) - 1, 1022))
    end function jp_power_of_two

    pure subroutine jp_add(total, x)
        type(jp_expansion), intent(inout) :: total
        real(dp), intent(in) :: x
        real(dp) :: a, b, high, b_part, low, carried
        integer :: k, kept
        if (.not. abs(x) > 0.0_dp) return
        kept = 0
        carried = x
        do k = 1, total%n
            a = carried
            b = total%part(k)
            high = a + b
            b_part = high - a
            low = (a - (high - b_part)) + (b - b_part)
            carried = high
            if (abs(low) > 0.0_dp) then
                kept = kept + 1
                total%part(kept) = low
            end if
        end do
        if (abs(carried) > 0.0_dp) then
            kept = kept + 1
            total%part(kept) = carried
        end if
        total%n = kept
    end subroutine jp_add

    ! Dekker's product, with Veltkamp's splitting.
    pure subroutine jp_add_product(total, a, b)
        type(jp_expansion), intent(inout) :: total
        real(dp), intent(in) :: a, b
        real(dp) :: high, low, large, a1, a2, b1, b2
        if (.not. (abs(a) > 0.0_dp .and. abs(b) > 0.0_dp)) return
        high = a*b
        large = a*134217728.0_dp + a
        a1 = large - (large - a)
        a2 = a - a1
        large = b*134217728.0_dp + b
        b1 = large - (large - b)
        b2 = b - b1
        low = a2*b2 - (((high - a1*b1) - a2*b1) - a1*b2)
        call jp_add(total, low)
        call jp_add(total, high)
    end subroutine jp_add_product

    ! A sum of products of four numbers each, one after the other: nothing is rounded but the sum.
    pure function jp_exact_sum(factors) result(total)
        real(dp), intent(in) :: factors(:)
        real(dp) :: total
        type(jp_expansion) :: two, three, all
        integer :: k, i
        do k = 1, size(factors), 4
            two%n = 0
            three%n = 0
            call jp_add_product(two, factors(k), factors(k + 1))
            do i = 1, two%n
                call jp_add_product(three, two%part(i), factors(k + 2))
            end do
            do i = 1, three%n
                call jp_add_product(all, three%part(i), factors(k + 3))
            end do
        end do
        total = 0.0_dp
        do i = 1, all%n
            total = total + all%part(i)
        end do
    end function jp_exact_sum

    ! A polynomial, its constant term first, and its slope: Horner's scheme.
    pure subroutine jp_polynomial(p, u, value, slope)
        real(dp), intent(in) :: p(:), u
        real(dp), intent(out) :: value, slope
        integer :: k
        value = 0.0_dp
        slope = 0.0_dp
        do k = size(p), 1, -1
            slope = slope*u + value
            value = value*u + p(k)
        end do
    end subroutine jp_polynomial

    pure function jp_value(p, u) result(value)
        real(dp), intent(in) :: p(:), u
        real(dp) :: value, slope
        call jp_polynomial(p, u, value, slope)
    end function jp_value

    ! How many coefficients there are without zeros in the highest places.
    pure function jp_length(p) result(n)
        real(dp), intent(in) :: p(:)
        integer :: n
        do n = size(p), 1, -1
            if (.not. jp_equal(p(n), 0.0_dp)) return
        end do
    end function jp_length

    ! The place between two others where a polynomial without an extremum there changes sign: by
    ! Newton's method where that halves the step, else by halving the interval.
    pure function jp_crossing(p, first, last, low, high) result(u)
        real(dp), intent(in) :: p(:), first, last, low, high
        real(dp) :: u, from, to, step, value, slope, newton, next, shorter
        logical :: looked_for_short, halves
        integer :: k
        u = last
        if (jp_equal(high, 0.0_dp)) return
        from = first
        to = last
        u = from + (to - from)*0.5_dp
        step = to - from
        looked_for_short = .false.
        do k = 1, 1200
            call jp_polynomial(p, u, value, slope)
            if (jp_equal(value, 0.0_dp)) return
            if ((value > 0.0_dp) .eqv. (low > 0.0_dp)) from = u
            if ((value > 0.0_dp) .neqv. (low > 0.0_dp)) to = u
            newton = u - value/slope
            halves = abs(newton - u) <= abs(step)*0.5_dp
            next = from + (to - from)*0.5_dp
            if (from < newton .and. newton < to .and. halves) next = newton
            step = next - u
            u = next
            if (jp_equal(step, 0.0_dp) .or. jp_equal(next, from) .or. jp_equal(next, to)) return
            if (.not. looked_for_short .and. abs(step) < 2.0_dp**(-40)) then
                looked_for_short = .true.
                shorter = anint(u*2.0_dp**20)*2.0_dp**(-20)
                if (jp_equal(jp_value(p, shorter), 0.0_dp)) then
                    u = shorter
                    return
                end if
            end if
        end do
    end function jp_crossing

    ! The places between two others where a polynomial falls through zero, or changes sign either
    ! way; those of its derivative part them. Its values at the two are given.
    pure recursive subroutine jp_crossings(all, ends, values, falls, place, found)
        real(dp), intent(in) :: all(:), ends(2), values(2)
        logical, intent(in) :: falls
        real(dp), intent(out) :: place(5)
        integer, intent(out) :: found
        real(dp) :: rate(5), inner(5), from, to, low, high
        integer :: n, m, k, parts
        logical :: counts
        n = jp_length(all)
        parts = 0
        found = 0
        place = 0.0_dp
        if (n > 2) then
            rate(1:n - 1) = [(all(k + 1)*k, k=1, n - 1)]
            m = jp_length(rate(1:n - 1))
            call jp_crossings(rate(1:m), ends, &
                [jp_value(rate(1:m), ends(1)), jp_value(rate(1:m), ends(2))], .false., inner, parts)
        end if
        from = ends(1)
        low = values(1)
        do k = 1, parts + 1
            if (k <= parts) then
                to = inner(k)
                high = jp_value(all(1:n), to)
                counts = low > 0.0_dp .and. high <= 0.0_dp
            else
                to = ends(2)
                high = values(2)
                counts = low > 0.0_dp .and. high < 0.0_dp
            end if
            if (.not. falls) counts = (low < 0.0_dp) .neqv. (high < 0.0_dp)
            if (counts) then
                found = found + 1
                place(found) = jp_crossing(all(1:n), from, to, low, high)
            end if
            from = to
            low = high
        end do
    end subroutine jp_crossings

    ! The closest place of a curve X(0) + c Y(u) between two coordinates, given the gap xs - X(0)
    ! and the residuals (xs - X).Y' at the two, by which either one of them counts or a root
    ! between them is found. A number before the first coordinate stands for that end, one behind
    ! the last for the other.
    pure function jp_nearest_place(gx, gy, factor, x1, y1, x2, y2, x3, y3, from, to, low, high) &
            result(u)
        real(dp), intent(in) :: gx, gy, factor, x1, y1, x2, y2, x3, y3, from, to, low, high
        real(dp) :: u, p(6), place(7), inside(5)
        real(dp) :: reach_u(2), reach_v(2), step(2), twice(2), others(2), size_(2)
        logical :: is_end(7)
        integer :: n, k, best, roots
        p(1) = gx*x1 + gy*y1
        p(2) = (gx*x2 + gy*y2)*2.0_dp - factor*(x1*x1 + y1*y1)
        p(3) = ((gx*x3 + gy*y3) - factor*(x1*x2 + y1*y2))*3.0_dp
        p(4) = -((factor*((x1*x3 + y1*y3)*2.0_dp + (x2*x2 + y2*y2)))*2.0_dp)
        p(5) = -((factor*(x2*x3 + y2*y3))*5.0_dp)
        p(6) = -((factor*(x3*x3 + y3*y3))*3.0_dp)
        is_end = .false.
        n = merge(1, 0, low <= 0.0_dp)
        is_end(1) = n == 1
        place(1) = from
        call jp_crossings(p, [from, to], [low, high], .true., inside, roots)
        place(n + 1:n + roots) = inside(1:roots)
        n = n + roots
        if (high >= 0.0_dp .or. n == 0) then
            n = n + 1
            is_end(n) = .true.
            place(n) = to
        end if
        best = 1
        twice = [gx*2.0_dp, gy*2.0_dp]
        do k = 2, n
            ! |G_u|^2 - |G_v|^2 = (G_u - G_v).(G_u + G_v), against what rounding does to it.
            reach_u = jp_reach(place(k))
            reach_v = jp_reach(place(best))
            step = reach_v - reach_u
            others = twice - (reach_u + reach_v)
            size_ = (abs(twice) + abs(reach_u)) + abs(reach_v)
            if (step(1)*others(1) + step(2)*others(2) < &
                -((abs(step(1))*size_(1) + abs(step(2))*size_(2))*2.0_dp**(-48))) best = k
        end do
        u = place(best)
        if (is_end(best)) u = merge(from - 1.0_dp, to + 1.0_dp, jp_equal(u, from))
    contains
        ! c Y(u), with the coefficients of u, u^2, u^3 in Y.
        pure function jp_reach(v) result(reach)
            real(dp), intent(in) :: v
            real(dp) :: reach(2)
            reach(1) = (((x3*v + x2)*v + x1)*v)*factor
            reach(2) = (((y3*v + y2)*v + y1)*v)*factor
        end function jp_reach
    end function jp_nearest_place

end module jp_runtime
