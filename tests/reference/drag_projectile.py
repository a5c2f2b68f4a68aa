#!/usr/bin/env python3
"""Reference values of presets/numerical-methods/drag-projectile.json, in 50 digits, independent of Carom.

A disc flies under gravity and quadratic drag, m v' = m g - c |v| v, and bounces off a floor and two walls with
restitution e, without friction. Each flight is advanced by Taylor series of degree 30, whose coefficients come
from recurrences (w = s^2 = u^2 + v^2 for the speed s); the step is chosen so that the last terms stay below a
tolerance. An impact is the first root of a gap's own series, by bisection and then Newton's method.

The error estimate is the change from halving the tolerance ten times. Needs mpmath (Debian: python3-mpmath).
"""
from mpmath import mp, mpf, sqrt, polyval

mp.dps = 50
GRAVITY, DRAG, MASS, RESTITUTION = mpf("9.81"), mpf("0.05"), mpf("0.5"), mpf("0.9")
LEFT, RIGHT, FLOOR = mpf("-0.95"), mpf("0.95"), mpf("0.05")  # of the centre: walls and floor less the radius
START = [mpf(0), mpf(1), mpf(10), mpf(3)]  # x, y, u, v
TIMES = [mpf("2.0")]
DEGREE = 30


def series(state):
    """Taylor coefficients of x, y, u, v about now."""
    k = DRAG / MASS
    x, y, u, v = ([c] for c in state)
    s = [sqrt(u[0] ** 2 + v[0] ** 2)]
    for n in range(DEGREE):
        su = sum(s[i] * u[n - i] for i in range(n + 1))
        sv = sum(s[i] * v[n - i] for i in range(n + 1))
        x.append(u[n] / (n + 1))
        y.append(v[n] / (n + 1))
        u.append(-k * su / (n + 1))
        v.append((-k * sv - (GRAVITY if n == 0 else 0)) / (n + 1))
        w = sum(u[i] * u[n + 1 - i] + v[i] * v[n + 1 - i] for i in range(n + 2))
        s.append((w - sum(s[i] * s[n + 1 - i] for i in range(1, n + 1))) / (2 * s[0]))
    return x, y, u, v


def value(c, t):
    return polyval(c[::-1], t)


def first_root(gap, h):
    """First t in (0, h] with gap(t) = 0, falling; the gap at 0 is >= 0. None if there is none."""
    n = 64
    for i in range(1, n + 1):
        a, b = h * (i - 1) / n, h * i / n
        if value(gap, b) < 0:
            for _ in range(170):
                m = (a + b) / 2
                a, b = (m, b) if value(gap, m) > 0 else (a, m)
            return a
    return None


def run(tolerance):
    state, t, found, impacts = list(START), mpf(0), [], []
    for end in TIMES:
        while t < end:
            x, y, u, v = series(state)
            size = max(abs(c[k]) ** (mpf(1) / k) for c in (x, y, u, v) for k in (DEGREE - 1, DEGREE))
            h = min(tolerance ** (mpf(1) / DEGREE) / size, end - t, mpf("0.05"))
            gaps = [
                (0, [x[0] - LEFT] + x[1:]),
                (0, [RIGHT - x[0]] + [-c for c in x[1:]]),
                (1, [y[0] - FLOOR] + y[1:]),
            ]
            roots = [(r, axis) for axis, gap in gaps if (r := first_root(gap, h)) is not None]
            dt, axis = min(roots, default=(h, None))
            state = [value(c, dt) for c in (x, y, u, v)]
            t += dt
            if axis is not None:
                impacts.append((t, "wall" if axis == 0 else "floor"))
                state[2 + axis] *= -RESTITUTION
        found.append(list(state))
    return found, impacts


if __name__ == "__main__":
    coarse, _ = run(mpf("1e-30"))
    fine, impacts = run(mpf("1e-30") / 2**10)
    for t, what in impacts:
        print(f"impact at t = {mp.nstr(t, 17)} s, {what}")
    for t, a, b in zip(TIMES, coarse, fine):
        for name, p, q in zip(("x", "y", "velocity_x", "velocity_y"), a, b):
            print(f"t = {t} s: {name} = {mp.nstr(q, 20)}, change by halving {mp.nstr(abs(p - q), 2)}")
