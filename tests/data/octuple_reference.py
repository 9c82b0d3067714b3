#!/usr/bin/env python3
"""Writes octuple_reference.csv: exact values of the elementary functions at points of Octuple.

    python3 octuple_reference.py > octuple_reference.csv            (the committed file)
    python3 octuple_reference.py --random 500 --seed 7 --functions tan,sinh > /tmp/a.csv (another, for measuring)

Independent of the Rust code: mpmath (pip install mpmath) evaluates at 2000 bits and more.
Columns: function, x, y, value, tail.  x, y and value are numbers with 237 significant bits, each written
with 80 decimal digits, of which 73 suffice to tell it from its neighbours (beyond 1e+-400 in hexadecimal,
0xMpE = M * 2**E, because decimal literals of that size take long to read).  The function's true result at
exactly (x, y) is value + tail, where value is that result rounded to 237 bits and tail has 20 digits more.
An empty y means a function of one argument.
Rows of `parse` hold a decimal literal in x and the correctly rounded number in hexadecimal in value.
"""
import argparse
import random
import sys

from mpmath import mp, mpf, nstr

BITS = 237
WORK = 2000          # bits; more for arguments beyond 2**1000, see exact_value
SMALLEST = mpf(2) ** -261900  # below, a tail is not a normal number of Octuple
LARGEST = mpf(2) ** 262143


def at(prec):
    mp.prec = prec


def octuple(v):
    """v rounded to the nearest number with 237 significant bits, ties to even."""
    at(BITS)
    r = +mpf(v)
    at(WORK)
    return r


def lit(text):
    """The number of Octuple nearest to a decimal literal or an expression in pi."""
    return octuple(eval(text, {"pi": mp.pi, "mpf": mpf, "mp": mp}) if "p" in text else mpf(text))


def neighbours(v):
    """v and the numbers of Octuple next to it on either side."""
    m, e = mp.frexp(v)
    ulp = mp.ldexp(1, e - BITS)
    return [octuple(v), octuple(v - ulp), octuple(v + ulp)]


def spread(rng, n, low, high, signed=True):
    """n points whose magnitudes are spread evenly over the powers of two in [2**low, 2**high]."""
    out = []
    for _ in range(n):
        x = octuple(mp.ldexp(1 + mpf(rng.getrandbits(236)) / mpf(2) ** 236, rng.randint(low, high - 1)))
        out.append(-x if signed and rng.random() < 0.5 else x)
    return out


def extremes(signed=True):
    """Numbers near the ends of the exponent range, one of them subnormal, and the ends themselves."""
    some = [octuple(lit("1.3") * mpf(2) ** e) for e in (-262140, -200001, -5000, 5000, 200001, 262140)]
    some += [mpf(2) ** -262142, mpf(2) ** -262378, mpf(3 * 2**200 + 1) * mpf(2) ** -262370, octuple((2 - mpf(2) ** -236) * mpf(2) ** 262143)]
    return both(some) if signed else some


def both(points):
    return [s * p for p in points for s in (1, -1)]


def near_multiples_of_half_pi():
    """The numbers nearest to k*pi/2, where sine, cosine and tangent are tiny or huge."""
    ks = [1, 2, 3, 4, 5, 6, 7, 8, 11, 22, 355, 10**6 + 3, 10**30 + 57]
    return [octuple(k * mp.pi / 2) for k in ks]


def points(name, rng, n):
    tiny = [lit("1e-30"), lit("1e-35"), lit("1e-36"), lit("1e-71"), lit("1e-80"), lit("1e-300")]
    one = mpf(1)
    eps = mpf(2) ** -236
    near_one = [one - eps / 2, one - eps, one - mpf(2) ** -100, one - lit("1e-30"), lit("0.999"),
                lit("0.99"), lit("0.9"), lit("0.7071"), lit("0.5")]
    above_one = [one + eps, one + 2 * eps, one + mpf(2) ** -100, one + lit("1e-30"), lit("1.001"), lit("1.1")]
    near_one, above_one = [octuple(v) for v in near_one], [octuple(v) for v in above_one]
    plain = [lit(t) for t in ("0.1", "0.3", "0.5", "1", "1.7", "2.5", "10")]
    if name in ("sin", "cos", "tan"):
        return (both(tiny[:4]) + plain + near_multiples_of_half_pi()
                + [lit("1e10"), lit("1e60"), lit("1e72"), lit("1e100"), mpf(2) ** 300, lit("1e250")]
                + spread(rng, n, -40, 300) + spread(rng, n, 230, 245) + extremes()[::3])
    if name in ("asin", "acos"):
        return both(tiny + near_one) + spread(rng, n, -20, 0) + [octuple(1 - v) for v in spread(rng, n, -200, -1, False)]
    if name == "atan":
        return both(tiny + near_one + above_one + plain) + [lit("1e35"), lit("1e71"), lit("1e100")] + spread(rng, n, -150, 150) + extremes()[::3]
    if name == "atanh":
        return both(tiny + near_one) + spread(rng, n, -120, 0) + [octuple(1 - v) for v in spread(rng, n, -200, -1, False)]
    if name == "acosh":
        return above_one + plain[3:] + [lit("1e30"), lit("1e100"), lit("1e300")] + [octuple(1 + v) for v in spread(rng, n, -150, 150, False)] + extremes(False)[3:6]
    if name == "asinh":
        return both(tiny + near_one + plain) + [lit("1e30"), lit("1e100"), lit("-1e300")] + spread(rng, n, -150, 200) + spread(rng, n, -1, 1) + extremes()[::3]
    if name in ("ln", "log2", "log10"):
        return near_one + above_one + plain + tiny + [lit("1e100"), lit("8"), lit("1000")] + [octuple(1 + v) for v in spread(rng, n, -200, 0)] + spread(rng, n, -500, 500, False) + extremes(False)
    if name == "ln_1p":
        return both(tiny) + plain + [-v for v in near_one] + [lit("1e100")] + spread(rng, n, -250, 0) + spread(rng, n, 0, 300, False) + extremes(False)[3:]
    if name in ("exp", "exp_m1", "exp2"):
        return both(tiny + plain + [one + eps, lit("0.6931471805599453"), lit("100"), lit("700"), lit("9000.5"), lit("181000.25"), lit("181500.25"), lit("261000.75"), lit("261890.75")]) + spread(rng, n, -240, 9) + spread(rng, n, 9, 17)
    if name in ("sinh", "cosh", "tanh"):
        return both(tiny[:5] + plain + [lit("0.01"), lit("50"), lit("81"), lit("82"), lit("83"), lit("700"), lit("89.9"), lit("90.1"), lit("181700"), lit("181704.8")]) + spread(rng, n, -120, 9) + spread(rng, n, -2, 2)
    if name == "cbrt":
        return both(tiny + plain + above_one + [lit("27"), lit("1e100")]) + spread(rng, n, -500, 500) + extremes()[::3]
    if name == "sqrt":
        return tiny + near_one + plain + above_one + [lit("1e300")] + spread(rng, n, -500, 500, False) + extremes(False)
    if name.startswith("sph_j"):
        return both(tiny[:5] + [lit("1e-8"), lit("1e-3"), lit("0.03"), lit("0.99"), lit("2"), lit("3"), lit("4")]) + plain + [lit("30"), lit("1e5"), lit("1e40")] + spread(rng, n, -60, 30) + spread(rng, n, -2, 4)
    raise KeyError(name)


def pairs(name, rng, n):
    mixed = spread(rng, n, -60, 60)
    other = spread(rng, n, -60, 60)
    if name in ("add", "sub"):
        close = spread(rng, n, -3, 3)
        return (list(zip(mixed, other)) + [(v, w) for v in close for w in neighbours(-v)[1:]]
                + [(lit("1"), mpf(2) ** -237), (lit("1"), octuple(mpf(2) ** -237 + mpf(2) ** -400)), (lit("1"), -mpf(2) ** -238),
                   (octuple(1 + eps237()), mpf(2) ** -237), (lit("0.1"), lit("0.2")), (lit("1e30"), lit("-1e-30"))])
    if name in ("mul", "div"):
        return list(zip(mixed, other)) + [(lit("0.1"), lit("3")), (lit("1"), lit("3")), (lit("1e-200"), lit("1e150")),
                                          (octuple(1 + eps237()), octuple(1 - eps237())), (lit("2"), lit("3")), (lit("1"), lit("49"))]
    if name == "mul_add":  # x*x + y, which cancels
        return [(v, octuple(-v * v)) for v in mixed] + list(zip(mixed, other)) + [(lit("0.1"), lit("-0.01"))] \
            + [(v, mp.ldexp(octuple(w), e)) for v, w in zip(mixed, other) for e in (-480, -300, -240, 240, 300, 480)]
    if name == "mul_residual":  # what rounding cuts off x*y, exactly
        return list(zip(mixed, other)) + [(lit("0.1"), lit("3"))] + [(v, v) for v in extremes(False)[1:5:3]]
    if name == "rem":
        return list(zip(mixed, other)) + [(lit("-7"), lit("0.1")), (lit("1e300"), lit("3")), (lit("1e-300"), lit("3")), (mpf(2) ** 262000, lit("0.3"))]
    if name == "atan2":
        axes = both([lit("1e-60"), lit("1e-30"), lit("0.3"), lit("1"), lit("7"), lit("1e40"), lit("1e200")])
        grid = [(y, x) for y in axes[::3] for x in axes[1::2]] + [(lit("1"), lit(t)) for t in ("1", "-1", "1e-80", "-1e-80", "1e80", "-1e80", "1e300", "-1e300", "1e-300")]
        return grid + [(-y, x) for y, x in grid[:8]] + list(zip(mixed, other)) + [(v, w) for v in mixed for w in neighbours(v)]
    if name == "powi":
        ns = [2, 3, -1, -2, 7, -13, 30, 100, -1000, 12345]
        bases = [lit(t) for t in ("0.1", "-1.7", "3", "1.0001", "-0.999", "10")]
        bases_near_one = [(lit("0.9"), mpf(k)) for k in (300000, -1500000)] + [(octuple(1 + mpf(2) ** -40), mpf(k)) for k in (2**31 - 1, -(2**31))]
        return bases_near_one + [(b, mpf(k)) for b in bases for k in ns] + [(v, mpf(rng.randint(-60, 60))) for v in spread(rng, n, -10, 10)]
    if name == "powf":  # the exponent is an f64
        ns = [mpf(v) for v in (0.5, -0.5, 1.5, 0.1, -2.7, 3.0, -4.0, 33.3, 1e-20, 1e-5, 1000.25)]
        near = [(octuple(1 + d), y) for d, y in ((mpf(2) ** -236, mpf(2) ** 240), (-mpf(2) ** -237 * 5, mpf(2) ** 250), (lit("1e-20"), mpf(1e22)),
                                                 (lit("-1e-9"), mpf(5e9) + 0.5), (lit("1e-5"), mpf(2) ** 33 + 0.25), (lit("-1e-13"), mpf(-1e18)))]
        far = [(lit("0.9"), mpf(300000.5)), (lit("0.9"), mpf(-500000.25)), (lit("2"), mpf(261000.5)), (mpf(2) ** -262300, mpf(-0.75)), (mpf(2) ** -200000, mpf(-1.25)),
               (octuple(1 + mpf(2) ** -200), mpf(2) ** -30), (octuple(1 + mpf(2) ** -200), mpf(3) + mpf(2) ** -45), (lit("10"), mpf(2) ** -235)]
        bases = [lit(t) for t in ("0.1", "1.7", "3", "1.0001", "0.999", "10", "1e-30")] + [octuple(1 + eps237()), octuple(1 + mpf(2) ** -60)]
        return near + far + [(b, k) for b in bases for k in ns] + [(v, mpf(rng.uniform(-20, 20))) for v in spread(rng, n, -30, 30, False)]
    if name == "log":  # the base is an f64
        bases = [mpf(v) for v in (2.0, 10.0, 0.5, 1.0000001, 7.3, 1e10)]
        return [(v, b) for b in bases for v in (lit("0.1"), lit("8"), lit("1e30"), octuple(1 + eps237()), lit("0.999"))] \
            + [(v, mpf(rng.uniform(1.5, 50))) for v in spread(rng, n, -100, 100, False)]
    raise KeyError(name)


def eps237():
    return mpf(2) ** -236


def j1(x):
    return mp.sin(x) / x**2 - mp.cos(x) / x


def j2(x):
    return (3 / x**3 - 1 / x) * mp.sin(x) - 3 / x**2 * mp.cos(x)


def remainder(x, y):
    """x - y*trunc(x/y), in integers."""
    (xm, xe), (ym, ye) = ((-v._mpf_[1] if v < 0 else v._mpf_[1], v._mpf_[2]) for v in (x, y))
    e = min(xe, ye)
    a, b = abs(xm) << (xe - e), abs(ym) << (ye - e)
    return mp.ldexp(a % b, e) * (-1 if x < 0 else 1)


UNARY = {
    "sqrt": mp.sqrt, "cbrt": lambda x: mp.sign(x) * mp.cbrt(abs(x)), "sin": mp.sin, "cos": mp.cos, "tan": mp.tan,
    "asin": mp.asin, "acos": mp.acos, "atan": mp.atan, "exp": mp.exp, "exp_m1": mp.expm1, "exp2": lambda x: mpf(2) ** x,
    "ln": mp.log, "ln_1p": mp.log1p, "log2": lambda x: mp.log(x) / mp.log(2), "log10": lambda x: mp.log(x) / mp.log(10),
    "sinh": mp.sinh, "cosh": mp.cosh, "tanh": mp.tanh, "asinh": mp.asinh, "acosh": mp.acosh, "atanh": mp.atanh,
    "sph_j0": lambda x: mp.sin(x) / x, "sph_j1": j1, "sph_j2": j2,
}
BINARY = {
    "add": lambda x, y: x + y, "sub": lambda x, y: x - y, "mul": lambda x, y: x * y, "div": lambda x, y: x / y,
    "mul_add": lambda x, y: x * x + y, "mul_residual": lambda x, y: x * y - octuple(x * y), "rem": remainder, "atan2": mp.atan2, "powi": lambda x, y: x ** int(y), "powf": lambda x, y: x ** y,
    "log": lambda x, y: mp.log(x) / mp.log(y),
}


def literal(v, digits=80):
    if v and abs(mp.frexp(v)[1]) > 1300:
        at(4 * digits)
        text = hexadecimal(+v)
        at(WORK)
        return text
    return decimal(v, digits)


def decimal(v, digits=80):
    return nstr(v, digits, strip_zeros=True, min_fixed=-5, max_fixed=5) if v else "0"


def row(name, x, y, exact):
    if exact and not SMALLEST < abs(exact) < LARGEST:
        return
    value = octuple(exact)
    tail = exact - value
    print(",".join([name, literal(x), "" if y is None else literal(y), literal(value), literal(tail, 20)]))


def hexadecimal(v):
    """v = m * 2**e with an integral m, as text '±0xMp±E'."""
    sign, man, exp, _ = v._mpf_
    return f"{'-' if sign else ''}0x{man:x}p{exp}"


def parse_rows(rng, n):
    """Literals of every length; halfway cases cut short and extended by one digit far out."""
    texts = ["1", "-0.1", "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803",
             "1e-30", "1e308", "123456789.987654321e-40", "9007199254740993", "0.5e1", "1e1000", "-7.25e-1000"]
    for v in spread(rng, n, -300, 300):
        m, e = mp.frexp(v)
        texts.append(decimal(v, 75))
        middle = v + mp.ldexp(mp.sign(v), e - BITS - 1)  # exact midpoint of v and its neighbour, away from 0
        at(4000)
        full = nstr(middle, 1000, strip_zeros=True, min_fixed=-400, max_fixed=400)
        at(WORK)
        if abs(e) < 60:
            texts += [full, full + ("1" if "." in full else ".000001")]
            if abs(e) < 4:
                texts.append(full + "0" * 400 + "1")
    for text in texts:
        at(6000)
        exact = mpf(text)
        value = octuple(exact)
        print(",".join(["parse", text, "", hexadecimal(value), ""]))


def main():
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--random", type=int, default=4, help="random points per range")
    args.add_argument("--seed", type=int, default=20)
    args.add_argument("--functions", help="only these, separated by commas")
    args = args.parse_args()
    at(WORK)
    rng = random.Random(args.seed)
    print("# Written by octuple_reference.py; do not edit. function,x,y,value,tail")
    wanted = set(args.functions.split(",")) if args.functions else {*UNARY, *BINARY, "parse"}
    for name, f in UNARY.items():
        if name not in wanted:
            continue
        for x in dict.fromkeys(points(name, rng, args.random)):
            row(name, x, None, exact_value(lambda: f(x), x))
    for name, f in BINARY.items():
        if name not in wanted:
            continue
        for x, y in dict.fromkeys(pairs(name, rng, args.random)):
            row(name, x, y, exact_value(lambda: f(x, y), x, y))
    if "parse" in wanted:
        parse_rows(rng, args.random)


def exact_value(f, *arguments):
    """f evaluated with enough bits for the arguments, and with twice as many; the two must agree to 400 bits."""
    global WORK
    ordinary = WORK
    WORK = max([ordinary] + [2 * abs(mp.frexp(v)[1]) for v in arguments])
    at(WORK)
    first = f()
    at(2 * WORK)
    second = f()
    if abs(first - second) > abs(second) * mpf(2) ** -400:
        sys.exit(f"not enough working precision: {nstr(first, 30)} against {nstr(second, 30)} at {[nstr(v, 30) for v in arguments]}")
    WORK = ordinary
    at(WORK)
    return +second


if __name__ == "__main__":
    main()
