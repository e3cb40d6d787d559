#!/usr/bin/env python3
"""Free rotation of 1000 random rigid bodies in multiple precision.

    python3 generate.py                 draw the bodies, solve them, write random-bodies.csv
    python3 generate.py --taylor 4      solve 4 random bodies of each kind again by Taylor series and compare
    python3 generate.py --bits          compare the closed map with itself at twice the precision
    python3 generate.py --steps FILE    compare a file of single steps (free-rotation-check.csv) with both methods

Needs Python 3.9 or later and gmpy2 (Debian: python3-gmpy2). Deterministic. Quaternions: scalar first, body to world.
"""
import argparse
import csv
import math
import pathlib
import random
import time
from fractions import Fraction
from operator import mul

import gmpy2
from gmpy2 import mpfr, sqrt

SEED = 20260517
BODIES = 1000
BITS = 1000                                   # of the closed map; --taylor uses TAYLOR_BITS
TAYLOR_BITS, ORDER, TOLERANCE = 220, 44, mpfr("1e-48")
SERIES = 40                                   # terms of the series that starts the doublings
EPS = mpfr(2)**-53
SAMPLES = (10, 50, 100)
DT = 1/50
HERE = pathlib.Path(__file__).parent
NAMES = ["kind", "I1", "I2", "I3", "w1", "w2", "w3"] + [
    f"{name}_{t}" for t in SAMPLES for name in ("q0", "q1", "q2", "q3", "floor")] + ["w1_100", "w2_100", "w3_100"]


# ---------------------------------------------------------------- small algebra

def dot(a, b): return sum(map(mul, a, b))
def norm(a): return sqrt(dot(a, a))
def cross(a, b): return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]


def unit(a):
    n = norm(a)
    return [x/n for x in a]


def product(a, b):
    w, x, y, z = a
    W, X, Y, Z = b
    return [w*W - x*X - y*Y - z*Z, w*X + x*W + y*Z - z*Y, w*Y - x*Z + y*W + z*X, w*Z + x*Y - y*X + z*W]


def conjugate(q): return [q[0], -q[1], -q[2], -q[3]]


def angle(p, q):
    """Angle of the rotation from attitude p to attitude q."""
    d = product(conjugate(p), q)
    return 2*gmpy2.atan2(norm(d[1:]), abs(d[0]))


# ---------------------------------------------------------------- the closed map

def convolve(a, b): return sum(map(mul, a, reversed(b)))


class Map:
    """The flow of one body over any time, by doubling S, c1, c3 and psi from a short time."""

    def __init__(self, moments, w):
        middle = sorted(range(3), key=lambda i: moments[i])[1]
        self.axes = [(middle + 2) % 3, middle, (middle + 1) % 3]         # a cyclic relabelling
        I1, I2, I3 = I = [mpfr(moments[i])/moments[middle] for i in self.axes]
        w1, w2, w3 = self.w = [mpfr(w[i]) for i in self.axes]
        self.I = I
        self.k = [(I2 - I3)/I1, (I3 - I1)/I2, (I1 - I2)/I3]
        if I1 == I3:
            g1 = g3 = I2/2
        else:
            g1, g3 = I2*(I3 - I2)/(I3 - I1), I2*(I2 - I1)/(I3 - I1)
        self.A1, self.A3 = A1, A3 = I1*w1*w1 + g1*w2*w2, I3*w3*w3 + g3*w2*w2
        self.T2, self.L2 = A1 + A3, I1*A1 + I3*A3
        self.L = sqrt(self.L2)
        P = I1*I2*I3
        self.alpha, self.beta = A3*(I3 - I1)*(I3 - I2)/P, A1*(I3 - I1)*(I2 - I1)/P
        self.delta = -(g3*I1*w1*w1 - g1*I3*w3*w3)*(I3 - I1)**2/(I2*P)
        self.rate = max(sqrt(self.alpha), sqrt(self.beta), self.T2/self.L)
        self._series()

    def _series(self):
        """Coefficients of S, c1, c3, psi in the time; S' = c1 c3, c1' = -alpha S c3, c3' = -beta S c1."""
        S, c1, c3 = [mpfr(0)], [mpfr(1)], [mpfr(1)]
        for k in range(SERIES):
            s, a, b = convolve(c1, c3), convolve(S, c3), convolve(S, c1)
            S.append(s/(k + 1))
            c1.append(-self.alpha*a/(k + 1))
            c3.append(-self.beta*b/(k + 1))
        x, y = self.I[0]*self.A1, self.I[2]*self.A3
        top = [self.L*(self.A1*a + self.A3*b) for a, b in zip(c1, c3)]
        bottom = [x*a + y*b for a, b in zip(c1, c3)]
        top[0] += self.L*self.T2
        bottom[0] += self.L2
        slope = []
        for k in range(SERIES):                                          # psi' = top/bottom
            slope.append((top[k] - dot(slope, reversed(bottom[1:k + 1])))/bottom[0])
        self.series = S, c1, c3, [mpfr(0)] + [p/(k + 1) for k, p in enumerate(slope)]

    def chain(self, h, last):
        """Yields (t, constants) for t = h, 2h, 4h, ... up to last."""
        I1, _, I3 = self.I
        n = max(0, int(gmpy2.ceil(gmpy2.log2(self.rate*h*256))))         # rate h / 2^n <= 1/256
        t = mpfr(h)/2**n
        S, c1, c3, psi = (_horner(a, t) for a in self.series)
        s, C = gmpy2.sin_cos(psi/2)
        for i in range(10**6):
            if i >= n:
                yield h*2**(i - n), (S, c1, c3, C, s)
                if h*2**(i - n + 1) > last:
                    return
            num = (I3 - I1)*S*self.A1*self.A3*(c3 - c1)
            den = self.L*(I1*self.A1*c1*(1 + c1) + I3*self.A3*c3*(1 + c3))
            a1, a3, S2 = c1*c1, c3*c3, S*S
            Delta = a1 + self.alpha*S2*a3
            S, c1, c3 = 2*S*c1*c3/Delta, (a1*a3 - self.delta*S2)/Delta, (a1*a3 + self.delta*S2)/Delta
            C, s = C*C - s*s, 2*C*s
            r = sqrt(num*num + den*den)
            x, y = den/r, num/r
            C, s = C*x + s*y, s*x - C*y

    def state(self, constants, sign=1):
        """(q, w) at the time of these constants, in the axes the body was given in; q(0) = 1."""
        S, c1, c3, C, s = constants
        S, s = sign*S, sign*s
        (w1, w2, w3), (k1, k2, k3) = self.w, self.k
        D = c1*c1 - k1*k2*S*S*w3*w3
        after = [(w1*c1 + k1*S*c3*w2*w3)/D, (w2*c1*c3 + k2*S*w3*w1)/D, (w3*c3 + k3*S*c1*w1*w2)/D]
        M, N = [list(map(mul, self.I, v)) for v in (self.w, after)]
        both = [a + b for a, b in zip(M, N)]
        v = [C*a + self.L*s*b for a, b in zip(cross(N, M), both)]
        r = unit([C*dot(both, both)/2] + v)
        q, w = [r[0], 0, 0, 0], [0, 0, 0]
        for place, axis in enumerate(self.axes):
            q[1 + axis], w[axis] = r[1 + place], after[place]
        return q, w

    def at(self, h):
        """(q, w) at time h, which may be negative or no whole number."""
        h = mpfr(h)
        return self.state(next(self.chain(abs(h), abs(h)))[1], 1 if h >= 0 else -1)

    def seconds(self, last=100):
        """{t: (q, w)} for t = 1, 2, ..., last."""
        found = {}
        for odd in range(1, last + 1, 2):
            for t, constants in self.chain(odd, last):
                found[t] = self.state(constants)
        return found


def _horner(coefficients, x):
    total = mpfr(0)
    for c in reversed(coefficients):
        total = total*x + c
    return total


# ---------------------------------------------------------------- Taylor series, the independent method

def taylor(moments, w, times):
    """[(q, w)] at the increasing times, from I w' = I w x w and q' = q (0, w)/2; q(0) = 1. No closed form anywhere."""
    I1, I2, I3 = [mpfr(x) for x in moments]
    k1, k2, k3 = (I2 - I3)/I1, (I3 - I1)/I2, (I1 - I2)/I3
    w, q = [mpfr(x) for x in w], [mpfr(1), mpfr(0), mpfr(0), mpfr(0)]
    sign = -1 if times[0] < 0 else 1
    t, states = mpfr(0), []
    for end in map(mpfr, times):
        while t != end:
            a, b, c = [w[0]], [w[1]], [w[2]]
            p, x, y, z = [q[0]], [q[1]], [q[2]], [q[3]]
            for k in range(ORDER):
                A, B, C = a[::-1], b[::-1], c[::-1]
                n = 2*(k + 1)
                da = k1*sum(map(mul, b, C))/(k + 1)
                db = k2*sum(map(mul, c, A))/(k + 1)
                dc = k3*sum(map(mul, a, B))/(k + 1)
                dp = -(sum(map(mul, x, A)) + sum(map(mul, y, B)) + sum(map(mul, z, C)))/n
                dx = (sum(map(mul, p, A)) + sum(map(mul, y, C)) - sum(map(mul, z, B)))/n
                dy = (sum(map(mul, p, B)) + sum(map(mul, z, A)) - sum(map(mul, x, C)))/n
                dz = (sum(map(mul, p, C)) + sum(map(mul, x, B)) - sum(map(mul, y, A)))/n
                for series, new in zip((a, b, c, p, x, y, z), (da, db, dc, dp, dx, dy, dz)):
                    series.append(new)
            length = norm(w)
            h = None
            for k in (ORDER - 1, ORDER):
                size = max(norm([a[k], b[k], c[k]])/length, norm([p[k], x[k], y[k], z[k]]))
                if size > 0:
                    bound = (TOLERANCE/size)**(mpfr(1)/k)
                    h = bound if h is None else min(h, bound)
            if h is None or h >= abs(end - t):
                h, t = end - t, end
            else:
                h = sign*h
                t += h
            w, q = [_horner(s, h) for s in (a, b, c)], [_horner(s, h) for s in (p, x, y, z)]
        states.append((q, w))
    return states


# ---------------------------------------------------------------- the bodies

def log_uniform(r, low, high): return math.exp(r.uniform(math.log(low), math.log(high)))
def sign(r): return r.choice((-1.0, 1.0))


def masses(r, a, b, c):
    """Ascending moments of a body with these second moments of its mass, which makes it a real body."""
    return sorted((b + c, a + c, a + b))


def mild(r): return masses(r, *(r.uniform(0.1, 1) for _ in range(3)))
def direction(r): return [r.gauss(0, 1) for _ in range(3)]


def ulps(x, n):
    """The double n places above x."""
    for _ in range(n):
        x = math.nextafter(x, math.inf)
    return x


def pair(r, gap):
    """A body with two moments that differ by gap(x), larger or smaller than the third."""
    x = r.uniform(0.2, 1)
    y = gap(x)
    return sorted((x, y, x*(r.uniform(1.05, 1.95) if r.random() < 0.5 else log_uniform(r, 1e-2, 0.95))))


def separatrix(r):
    I1, I2, I3 = I = mild(r)
    w3, off = r.gauss(0, 1), 0.0 if r.random() < 0.25 else sign(r)*log_uniform(r, 1e-16, 1e-5)
    return I, [sign(r)*w3*math.sqrt(I3*(I3 - I2)/(I1*(I2 - I1)))*(1 + off), r.gauss(0, 1), w3]


def unstable(r):
    small = [sign(r)*log_uniform(r, 1e-10, 1e-2) for _ in range(2)]
    if r.random() < 0.2:
        small[r.randrange(2)] = 0.0
    return mild(r), [small[0], sign(r), small[1]]


def axis(r):
    w, on = [0.0, 0.0, 0.0], r.randrange(3)
    if r.random() < 0.5:
        size = log_uniform(r, 1e-14, 1e-2)
        w = [size*r.gauss(0, 1) for _ in range(3)]
    w[on] = sign(r)
    return mild(r), w


def without(r, *places):
    w = direction(r)
    w[r.choice(places)] = 0.0
    return mild(r) if r.random() < 0.7 else ratios(r), w


def ratios(r):
    if r.random() < 0.5:
        return masses(r, *(log_uniform(r, 1e-6, 1) for _ in range(3)))
    thin = log_uniform(r, 1e-6, 1)                                       # the largest moment over the smallest
    share = log_uniform(r, 1e-6, 0.5)
    return masses(r, 1, thin*share, thin*(1 - share))


def flat(r):
    a, b = log_uniform(r, 1e-2, 1), r.uniform(0.1, 1)
    return sorted((a, b, a + b))


def needle(r):
    thin = log_uniform(r, 1e-7, 1e-2)
    I = masses(r, r.uniform(0.1, 1), thin*r.uniform(0.1, 1), thin*r.uniform(0.1, 1))
    w = direction(r)
    if r.random() < 0.5:                                                 # spinning about the long axis
        w = [w[0], 0.1*w[1], 0.1*w[2]]
    return I, w


def near_isotropic(r):
    x, gap = r.uniform(0.2, 1), log_uniform(r, 1e-14, 1e-1)
    return sorted(x*(1 + gap*r.uniform(-1, 1)) for _ in range(3))


def scaled(I, factor): return [x*factor for x in I]


KINDS = {
    "ratios to 1e6": lambda r: (ratios(r), direction(r)),
    "mild": lambda r: (mild(r), direction(r)),
    "two equal to 1e-3": lambda r: (pair(r, lambda x: x*(1 + 1e-3*r.uniform(0.1, 1))), direction(r)),
    "two equal to 1e-9": lambda r: (pair(r, lambda x: x*(1 + 1e-9*r.uniform(0.1, 1))), direction(r)),
    "two equal to some ulp": lambda r: (pair(r, lambda x: ulps(x, r.randint(1, 8))), direction(r)),
    "two equal": lambda r: (pair(r, lambda x: x), direction(r)),
    "flat": lambda r: (flat(r), direction(r)),
    "needle": needle,
    "near isotropic": lambda r: (near_isotropic(r), direction(r)),
    "isotropic": lambda r: ([r.uniform(0.01, 10)]*3, direction(r)),
    "near the separatrix": separatrix,
    "near the unstable axis": unstable,
    "on and near an axis": axis,
    "w2 = 0": lambda r: without(r, 1),
    "w1 or w3 = 0": lambda r: without(r, 0, 2),
    "fast": lambda r: (r.choice((mild, mild, ratios, flat))(r), direction(r)),
    "units": lambda r: (scaled(r.choice((mild, ratios))(r), log_uniform(r, 1e-19, 1e-17)), direction(r)),
}
ORDERS = ((0, 1, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0), (1, 0, 2), (0, 2, 1))


def real(I):
    """The triangle inequality, exactly but for one rounding of the sum."""
    a, b, c = sorted(map(Fraction, I))
    return a > 0 and a + b >= c*(1 - Fraction(1, 2**53))


def bodies():
    """[(kind, moments, w)]: the same ones every time."""
    kinds, drawn = list(KINDS), []
    for number in range(BODIES):
        kind = kinds[number % len(kinds)]
        r = random.Random(SEED*1000 + number)
        while True:
            I, w = KINDS[kind](r)
            if kind not in ("near isotropic", "isotropic", "units"):
                I = scaled(I, 2.0**r.randint(-6, 6))                     # exact, so that ties stay ties
            turn = log_uniform(r, 2, 50) if kind == "fast" else log_uniform(r, 0.01, 0.6)
            length = math.sqrt(sum(x*x for x in w))
            w = [x/length*turn/DT for x in w]
            if real(I):
                break
        order = ORDERS[number//len(kinds) % 6]
        drawn.append((kind, [I[i] for i in order], [w[i] for i in order]))
    return drawn


# ---------------------------------------------------------------- floors and the file

def perturbed(number, moments, w):
    """Four neighbours of a body within 2^-53: (moments, w, q)."""
    r = random.Random(SEED*1000 + number + 500_000_000)
    length = norm([mpfr(x) for x in w])
    for _ in range(4):
        I = [mpfr(x)*(1 + r.choice((-1, 1))*EPS) for x in moments]
        d, e = (unit([mpfr(r.gauss(0, 1)) for _ in range(n)]) for n in (3, 4))
        yield I, [x + EPS*length*u for x, u in zip(w, d)], unit([(i == 0) + EPS*u for i, u in enumerate(e)])


def solve(number, moments, w):
    """(states of the body at 1..100 s, {t: floor})."""
    truth = Map(moments, w).seconds()
    worst = {t: 0.0 for t in truth}
    for I, v, q in perturbed(number, moments, w):
        for t, state in Map(I, v).seconds().items():
            worst[t] = max(worst[t], float(angle(truth[t][0], product(q, state[0]))))
    floor, highest = {}, 0.0
    for t in sorted(worst):
        floor[t] = highest = max(highest, worst[t])
    return truth, floor


def digits(values):
    """20 significant digits; what is below 1e-45 of the largest is written 0."""
    largest = max(map(abs, values))
    return [f"{x:.20g}" if abs(x) > largest*mpfr("1e-45") else "0" for x in values]


def invariants(moments, w, q, v):
    """Largest relative change of the energy and of the angular momentum in the world."""
    M, N = [[mpfr(i)*x for i, x in zip(moments, u)] for u in (w, v)]
    world = product(product(q, [mpfr(0)] + N), conjugate(q))[1:]
    energy = dot(M, w)
    return max(abs(dot(N, v)/energy - 1), norm([a - b for a, b in zip(world, M)])/norm(M))


def write(count):
    gmpy2.get_context().precision = BITS
    start, worst = time.time(), mpfr(0)
    with open(HERE/"random-bodies.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(NAMES)
        for number, (kind, I, w) in enumerate(bodies()[:count]):
            states, floor = solve(number, I, w)
            worst = max([worst] + [invariants(I, w, *state) for state in states.values()])
            row = [kind] + [repr(x) for x in I + w]
            for t in SAMPLES:
                row += digits(states[t][0]) + [f"{floor[t]:.3g}"]
            out.writerow(row + digits(states[100][1]))
            if number % 50 == 49:
                file.flush()
                print(f"{number + 1} bodies, {time.time() - start:.0f} s, energy and momentum kept to {float(worst):.1e}", flush=True)


# ---------------------------------------------------------------- checks

def difference(a, b):
    """(angle, difference of w relative to |w|) of two states."""
    return float(angle(a[0], b[0])), float(norm([x - y for x, y in zip(a[1], b[1])])/norm(b[1]))


def check_taylor(each, turns):
    """Random bodies of each kind by both methods, as far as `turns` radians allow, and the file by the closed map."""
    chosen, everything, start = [], list(enumerate(bodies())), time.time()
    r = random.Random(SEED + 1)
    rows = list(csv.DictReader(open(HERE/"random-bodies.csv")))
    for kind in KINDS:
        chosen += r.sample([b for b in everything if b[1][0] == kind], each)
    worst = {}
    for number, (kind, I, w) in chosen:
        length = math.sqrt(sum(x*x for x in w))
        times = [t for t in (0.1, 0.5, 1, 2, 5, 10, 50, 100) if length*t <= turns or t == 0.1]
        times = [t for t in times if t in SAMPLES] or times[-1:]
        gmpy2.get_context().precision = BITS
        closed = [Map(I, w).at(t) for t in times]
        gmpy2.get_context().precision = TAYLOR_BITS
        found = [difference(a, b) for a, b in zip(closed, taylor(I, w, times))]
        printed = 0.0
        for t, state in zip(times, closed):
            if t in SAMPLES:
                q = [mpfr(rows[number][f"q{i}_{t}"]) for i in range(4)]
                printed = max(printed, float(angle(q, state[0])))
        print(f"{kind:24} {number:4} to {times[-1]:5} s, {length*times[-1]:6.0f} rad: attitude {max(f[0] for f in found):.1e}"
              f" w {max(f[1] for f in found):.1e} file {printed:.1e}  {time.time() - start:.0f} s", flush=True)
        worst[kind] = max([worst.get(kind, 0.0)] + [x for f in found for x in f])
    for kind, value in worst.items():
        print(f"{kind:24} {value:.1e}")
    print(f"{len(chosen)} bodies, largest disagreement {max(worst.values()):.1e}")


def check_bits(count):
    """The closed map against itself with twice the bits and twice the terms of its series."""
    global SERIES
    worst, terms = 0.0, SERIES
    for number, (kind, I, w) in enumerate(bodies()[:count]):
        states = []
        for factor in (1, 2):
            gmpy2.get_context().precision, SERIES = factor*BITS, factor*terms
            m = Map(I, w)
            states.append([m.at(t) for t in SAMPLES])
        found = max(max(difference(a, b)) for a, b in zip(*states))
        if found > 1e-60:
            print(number, kind, found, flush=True)
        worst = max(worst, found)
    print(f"largest change with twice the bits and terms: {worst:.1e}")


def check_steps(path):
    """A file of single steps I, w, h -> w+, r against both methods (Taylor: every tenth row)."""
    lines = [line for line in open(path) if not line.startswith("#")]
    closed, series = [], []
    for number, row in enumerate(csv.reader(lines[1:])):
        I, w, h = [float(x) for x in row[:3]], [float(x) for x in row[3:6]], float(row[6])
        gmpy2.get_context().precision = BITS
        given = [mpfr(x) for x in row[10:14]], [mpfr(x) for x in row[7:10]]
        state = Map(I, w).at(h)
        relative = max(abs(abs(x) - abs(y))/max(abs(y), mpfr("1e-45")) for x, y in zip(state[0], given[0]))
        closed.append(difference(state, given) + (float(relative), number))
        if number % 10 == 0 and abs(h)*math.sqrt(sum(x*x for x in w)) < 300:
            gmpy2.get_context().precision = TAYLOR_BITS
            series.append(max(difference(taylor(I, w, [h])[0], state)))
    print(f"{len(closed)} steps: attitude {max(c[0] for c in closed):.1e} rad, w {max(c[1] for c in closed):.1e} of |w|, "
          f"components of r {max(c[2] for c in closed):.1e} of themselves; "
          f"{len(series)} by Taylor series against the map: {max(series):.1e}")


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--count", type=int, default=BODIES)
    arguments.add_argument("--taylor", type=int, metavar="N")
    arguments.add_argument("--turns", type=float, default=4000, help="radians that --taylor follows a body at most")
    arguments.add_argument("--bits", action="store_true", help="compare with twice the bits and terms")
    arguments.add_argument("--steps", metavar="FILE")
    chosen = arguments.parse_args()
    if chosen.taylor:
        check_taylor(chosen.taylor, chosen.turns)
    elif chosen.bits:
        check_bits(chosen.count)
    elif chosen.steps:
        check_steps(chosen.steps)
    else:
        write(chosen.count)
