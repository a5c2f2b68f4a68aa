#!/usr/bin/env python3
"""First times of contact in 100 digits, independent of Carom: writes tests/physics/contact_references.h.

    python3 tests/reference/roots.py > tests/physics/contact_references.h

Each case is a disc B that meets a body A: a disc or a box, fixed, flying or driven. Every number of a case is a
double and is taken as exactly that. Both fly on parabolas (a fixed or driven body does not fall), so the times at
which the centre of B crosses the curve around A, grown by the radius of B, are roots of polynomials of degree 4
at most: 4 segments and 4 arcs for a box. They are isolated between the roots of the derivative and refined by
Newton's method inside the bracket. A driven body swings, position + velocity t + amplitude sin(w t + phase): its
first root is bracketed by 4000 samples.

Each answer is checked by a gap function of its own: zero to 80 digits at the contact, positive before it; where
there is none, positive throughout. Needs mpmath (Debian: python3-mpmath).
"""
import math
from dataclasses import dataclass
from mpmath import mp, mpf, cos, sin, sqrt, nstr

mp.dps = 110  # 100 and some to lose
SAMPLES = 4000


@dataclass
class Case:
    name: str
    b: tuple  # position x, y, velocity x, y of disc B
    radius: float  # of B
    a: tuple = (0.0, 0.0, 0.0, 0.0)
    disc: float = 0.0  # radius of A if it is a disc
    box: tuple = (0.0, 0.0)  # width and height of A if it is a box
    angle: float = 0.0
    fixed: bool = True
    swing: tuple = (0.0, 0.0, 0.0, 0.0)  # amplitude x, y, angular frequency, phase of a driven A
    driven: bool = False
    gravity: float = 0.0  # downwards
    until: float = 1.0


# --- polynomials, as coefficients from the constant on ------------------------------------------------------------


def times(p, q):
    product = [mpf(0)] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for k, y in enumerate(q):
            product[i + k] += x * y
    return product


def plus(p, q):
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(n)]


def value(p, t):
    result = mpf(0)
    for c in reversed(p):
        result = result * t + c
    return result


def derivative(p):
    return [k * c for k, c in enumerate(p)][1:]


def root_between(f, slope, low, high):
    """The root in a bracket: bisection until Newton's steps stay inside and settle."""
    sign = f(low) > 0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(middle) > 0) == sign else (low, middle)
    t = (low + high) / 2
    for _ in range(400):
        low, high = (t, high) if (f(t) > 0) == sign else (low, t)
        steep = slope(t)
        new = t - f(t) / steep if steep != 0 else low
        if not low <= new <= high:
            new = (low + high) / 2
        if abs(new - t) <= mpf(10) ** (-mp.dps + 3) * abs(t):
            return new
        t = new
    return t


def real_roots(p, low, high):
    """All real roots of odd order in [low, high]."""
    while p and p[-1] == 0:
        p = p[:-1]
    if len(p) < 2:
        return []
    stops = [low] + real_roots(derivative(p), low, high) + [high]
    found = []
    for a, b in zip(stops, stops[1:]):
        fa, fb = value(p, a), value(p, b)
        if fa == 0:
            found.append(a)
        elif fa * fb < 0:
            found.append(root_between(lambda t: value(p, t), lambda t: value(derivative(p), t), a, b))
    if value(p, high) == 0:
        found.append(high)
    return sorted(set(found))


# --- motion and gap -------------------------------------------------------------------------------------------------


def relative_path(c):
    """B relative to A along the axes of A, as polynomials, and the swing's amplitude along the same axes."""
    ax, ay, au, av = map(mpf, c.a)
    bx, by, bu, bv = map(mpf, c.b)
    fall = mpf(0) if not (c.fixed or c.driven) else -mpf(c.gravity) / 2
    x, y = [bx - ax, bu - au, mpf(0)], [by - ay, bv - av, fall]
    p, q = mpf(c.swing[0]), mpf(c.swing[1])
    cs, sn = cos(mpf(c.angle)), sin(mpf(c.angle))
    along = plus([cs * k for k in x], [sn * k for k in y])
    across = plus([-sn * k for k in x], [cs * k for k in y])
    return along, across, cs * p + sn * q, -sn * p + cs * q


def position(c, path, t):
    x, y, p, q = path
    swing = sin(mpf(c.swing[2]) * t + mpf(c.swing[3]))
    return value(x, t) - p * swing, value(y, t) - q * swing


def gap(c, path, t):
    x, y = position(c, path, t)
    if c.disc > 0:
        return sqrt(x * x + y * y) - mpf(c.disc) - mpf(c.radius)
    dx, dy = abs(x) - mpf(c.box[0]) / 2, abs(y) - mpf(c.box[1]) / 2
    outside = sqrt(max(dx, mpf(0)) ** 2 + max(dy, mpf(0)) ** 2)
    return (outside if outside > 0 else max(dx, dy)) - mpf(c.radius)


def closing_speed(c, path, t):
    """-d(gap)/dt by the central difference of a function that is smooth here."""
    h = mpf(10) ** (-mp.dps // 3) * mpf(c.until)
    return (gap(c, path, t - h) - gap(c, path, t + h)) / (2 * h)


def crossings(c, path):
    """Times at which the centre of B crosses a piece of the grown outline of A."""
    x, y, _, _ = path
    r, end = mpf(c.radius), mpf(c.until)
    if c.disc > 0:
        reach = r + mpf(c.disc)
        return real_roots(plus(plus(times(x, x), times(y, y)), [-reach * reach]), mpf(0), end)
    found = []
    half = (mpf(c.box[0]) / 2, mpf(c.box[1]) / 2)
    for side in (-1, 1):
        for p, q, a, b in ((x, y, half[0], half[1]), (y, x, half[1], half[0])):
            found += [t for t in real_roots(plus(p, [-side * (a + r)]), mpf(0), end) if abs(value(q, t)) <= b]
        for other in (-1, 1):
            u, v = plus(x, [-side * half[0]]), plus(y, [-other * half[1]])
            arc = real_roots(plus(plus(times(u, u), times(v, v)), [-r * r]), mpf(0), end)
            found += [t for t in arc if value(u, t) * side >= 0 and value(v, t) * other >= 0]
    return sorted(found)


def first_contact(c):
    """The time, or None, and the closing speed there."""
    path = relative_path(c)
    start = gap(c, path, mpf(0))
    assert start >= 0, c.name
    if start == 0 and closing_speed(c, path, mpf(0)) > 0:
        return mpf(0), closing_speed(c, path, mpf(0))
    samples = [mpf(c.until) * k / SAMPLES for k in range(SAMPLES + 1)]
    if c.driven and any(c.swing):
        f = lambda t: gap(c, path, t)
        time = None
        for a, b in zip(samples[1:], samples[2:]):
            assert f(samples[1]) > 0, c.name
            if f(b) < 0:
                time = root_between(f, lambda t: -closing_speed(c, path, t), a, b)
                break
    else:
        inward = (t for t in crossings(c, path) if t > 0 and closing_speed(c, path, t) > 0)
        time = next(inward, None)
    size = mpf(c.radius) + mpf(c.disc) + mpf(sum(c.box))
    if time is not None:
        assert abs(gap(c, path, time)) < mpf(10) ** -80 * size, (c.name, gap(c, path, time))
    for t in samples[1:]:
        if time is None or t < time:
            assert gap(c, path, t) > 0 or (start == 0 and time is None and gap(c, path, t) == 0), (c.name, t)
    return time, None if time is None else closing_speed(c, path, time)


# --- the cases ------------------------------------------------------------------------------------------------------


def turned(angle, x, y):
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y


def cases():
    graze = (("hit", 1.0 - 1e-9), ("miss", 1.0 + 1e-9))
    disc = dict(disc=0.5, radius=0.25)
    box = dict(box=(2.0, 1.0), radius=0.25)
    all_cases = [
        # two discs on straight lines
        Case("discs, head-on", (3.0, 0.0, -2.0, 0.0), **disc, until=2.0),
        Case("discs, oblique, both fly", (3.1, 1.7, -2.3, -0.9), a=(-0.3, 0.2, 0.4, 0.7), fixed=False, disc=0.41,
             radius=0.23, until=2.0),
        Case("discs, both fall", (2.0, 1.0, -2.0, 3.0), a=(-0.3, 1.5, 0.4, 2.0), fixed=False, **disc, gravity=9.81,
             until=2.0),
        Case("discs, nearly parallel", (1.0, 0.0, -2e-8, 100.0), a=(0.0, 0.0, 0.0, 100.0), fixed=False, disc=0.5,
             radius=0.4999999, until=8.0),
        Case("discs, nearly parallel and oblique", (0.8, 0.7, 30.0, 40.0), a=(0.0, 0.0, 30.0001, 40.0001), fixed=False,
             disc=0.5, radius=0.5625, until=8.0),
        Case("discs, very slow", (1.000000004, 0.0, -1e-9, 0.0), disc=0.5, radius=0.5, until=8.0),
        Case("discs, slow over a long time", (1.7, 0.3, -1e-2, 0.0), disc=0.5, radius=0.5, until=120.0),
        Case("discs, very fast", (-1.3, 0.2, 1e6, 1e5), **disc, until=2e-6),
        Case("discs, very fast through a small one", (-700.0, 0.004, 1e6, 0.0), disc=0.005, radius=0.002, until=1e-3),
        Case("discs, very small", (3e-6, 4e-7, -1e-6, 0.0), disc=1e-6, radius=1e-6, until=3.0),
        Case("discs, very small and fast", (3e-6, 4e-7, -50.0, 0.0), disc=1e-6, radius=1e-6, until=1e-7),
        Case("discs, very large", (2.1e6, 3e5, -1e5, 0.0), disc=1e6, radius=1e6, until=4.0),
        Case("discs, very large, both fly", (2.1e6, 3e5, -4e5, 1e5), a=(-1e6, 2e5, 1e5, 1e5), fixed=False, disc=1e6,
             radius=1e6, until=4.0),
        Case("discs, small on large", (0.5, 1000001.0, 0.1, -1.0), disc=1e6, radius=1e-6, until=2.0),
        Case("discs, far from the origin", (1000003.0, -999999.5, -2.0, 0.0), a=(1e6, -1e6, 0.0, 0.0), disc=0.5,
             radius=0.5, until=3.0),
        Case("discs, touching and closing", (1.0, 0.0, -1.0, 0.5), disc=0.5, radius=0.5, until=1.0),
        Case("discs, touching and parting", (1.0, 0.0, 1.0, 0.5), disc=0.5, radius=0.5, until=1.0),
        Case("discs, touching and passing", (1.0, 0.0, 0.0, 1.0), disc=0.5, radius=0.5, until=1.0),
        Case("discs, no gap left but rounding", (math.nextafter(1.0, 2.0), 0.0, -1.0, 0.0), disc=0.5, radius=0.5,
             until=1.0),
        # a disc that falls past or on to a fixed disc
        Case("falling disc on disc", (0.2, 3.0, 0.1, 0.0), **disc, gravity=9.81, until=1.0),
        Case("thrown disc on disc", (-2.0, 0.0, 2.0, 4.0), **disc, gravity=9.81, until=1.2),
        Case("falling disc, very fast", (-1.5, 0.3, 1e6, 0.0), **disc, gravity=9.81, until=2e-6),
        Case("falling disc, very small", (1e-7, 5e-6, 1e-4, 0.0), disc=1e-6, radius=1e-6, gravity=9.81, until=2e-3),
        Case("falling disc, very large", (1e5, 3e6, 1e4, 0.0), disc=1e6, radius=1e6, gravity=1e6, until=4.0),
        Case("falling disc, thrown up where it touches", (0.0, 1.0, 0.0, 2.0), disc=0.5, radius=0.5, gravity=9.81,
             until=1.0),
        # a disc and a box on straight lines
        Case("disc on face", (-3.0, 0.1, 2.0, 0.3), **box, until=2.0),
        Case("disc on face, tilted", (-3.0, 0.1, 2.0, 0.3), **box, angle=0.35, until=2.0),
        Case("disc on corner", (-3.0, 0.61, 2.0, 0.0), **box, until=2.0),
        Case("disc on corner, tilted", (-3.0, -0.4, 2.0, 0.1), box=(1.0, 1.0), radius=0.25, angle=0.7853981633974483,
             until=2.0),
        Case("disc on face, nearly parallel", (-0.9, 0.7500009765625, 0.3, -1e-6), **box, until=4.0),
        Case("disc on face, nearly parallel, tilted", turned(0.25, -0.9, 0.7500009765625) + turned(0.25, 0.3, -1e-6),
             **box, angle=0.25, until=4.0),
        Case("disc on face, very slow", (0.3, 0.750000004, 0.0, -1e-9), **box, until=8.0),
        Case("disc on thin wall, very fast", (-3.0, 0.1, 1e6, 0.0), box=(1e-3, 2.0), radius=1e-2, until=4e-6),
        Case("disc on corner, very fast", (-3.0, 0.61, 1e6, 0.0), **box, until=4e-6),
        Case("disc on face, very small", (-4e-6, 1e-7, 1e-6, 0.0), box=(2e-6, 1e-6), radius=1e-6, until=4.0),
        Case("disc on corner, very small", (-4e-6, 1.3e-6, 1e-6, 0.0), box=(2e-6, 1e-6), radius=1e-6, until=4.0),
        Case("disc on face, very large", (-4e6, 1e5, 1e6, 0.0), box=(2e6, 1e6), radius=1e6, angle=0.1, until=4.0),
        Case("disc on corner, very large", (-4e6, 1.3e6, 1e6, 0.0), box=(2e6, 1e6), radius=1e6, until=4.0),
        Case("disc on face, touching and closing", (0.1, 0.75, 0.3, -1.0), **box, until=1.0),
        Case("disc on face, touching and sliding", (-0.9, 0.75, 0.5, 0.0), **box, until=1.0),
        # a disc that falls past or on to a fixed box
        Case("falling disc on floor", (0.1, 3.0, 0.3, 1.0), **box, gravity=9.81, until=2.0),
        Case("falling disc on ramp", (0.1, 3.0, 0.3, 1.0), **box, angle=-0.35, gravity=9.81, until=2.0),
        Case("falling disc on corner", (0.0, 2.0, 2.2, 0.0), **box, gravity=9.81, until=2.0),
        Case("falling disc on floor, very small", (0.0, 4e-6, 1e-4, 1e-5), box=(2e-6, 1e-6), radius=1e-6, gravity=9.81,
             until=1e-3),
        Case("falling disc on floor, very large", (0.0, 4e6, 1e4, 1e5), box=(2e6, 1e6), radius=1e6, gravity=1e6,
             until=4.0),
        Case("falling disc, thrown up from the floor", (0.1, 0.75, 0.3, 1.5), **box, gravity=9.81, until=1.0),
        Case("falling disc on floor, tiny hop", (0.1, 0.75, 0.0, 1e-5), **box, gravity=9.81, until=1e-5),
        # driven bodies
        Case("disc on piston", (-1.0, 0.1, 2.0, 0.0), a=(1.0, 0.0, -0.25, 0.0), driven=True, fixed=False,
             box=(0.5, 1.0), radius=0.25, until=1.0),
        Case("disc and piston, hardly faster", (-1.0, 0.1, 0.5, 0.0), a=(1.0, 0.0, 0.499, 0.0), driven=True,
             fixed=False, box=(0.5, 1.0), radius=1.749, until=4.0),
        Case("falling disc on swinging table", (0.1, 0.75, 0.0, 0.0), driven=True, fixed=False, box=(2.0, 0.5),
             radius=0.1, swing=(0.0, 0.0625, 12.5, 0.3), gravity=9.81, until=0.5),
        Case("falling disc on table that swings both ways", (0.9, 0.75, 0.0, 0.0), driven=True, fixed=False,
             box=(2.0, 0.5), radius=0.1, swing=(0.125, 0.0625, 12.5, 0.3), angle=0.2, gravity=9.81, until=0.5),
        Case("thrown from where it touches a swinging table", (0.0, 0.5, 0.0, 2.5), driven=True, fixed=False,
             box=(2.0, 0.5), radius=0.25, swing=(0.0, 0.0625, 12.5, 0.0), gravity=9.81, until=0.8),
    ]
    for name, k in graze:
        apart = 0.75 * k  # between the centres where they pass
        t, g = 0.4, 9.81
        all_cases += [
            Case(f"discs, grazing {name}", (-3.0, apart, 2.0, 0.0), **disc, until=3.0),
            Case(f"discs, grazing {name}, oblique", (-3.0 - 0.8 * apart, -4.0 + 0.6 * apart, 3.0, 4.0), **disc,
                 until=2.0),
            Case(f"discs, grazing {name}, both fly", (-3.0, apart, 3.0, 0.5), a=(0.0, 0.0, 1.0, 0.5), fixed=False,
                 **disc, until=3.0),
            Case(f"discs, grazing {name}, very fast", (-3.0, apart, 1e6, 0.0), **disc, until=6e-6),
            Case(f"discs, grazing {name}, very small", (-4e-6, 2e-6 * k, 1e-6, 0.0), disc=1e-6, radius=1e-6,
                 until=6.0),
            Case(f"discs, grazing {name}, very large", (-4e6, 2e6 * k, 1e6, 0.0), disc=1e6, radius=1e6, until=6.0),
            # over the top of the other disc at the highest point of the flight
            Case(f"thrown disc, grazing {name}", (-4.0 * t, apart - 0.5 * g * t * t, 4.0, g * t), **disc, gravity=g,
                 until=0.8),
            # along the face and over the corner: the corner is met first
            Case(f"disc along a face, grazing {name}", (-3.0, 0.5 + 0.25 * k, 2.0, 0.0), **box, until=3.0),
            Case(f"disc past a corner, grazing {name}",
                 (-1.0 - 2.0 - 0.25 * k * math.sqrt(0.5), 0.5 - 2.0 + 0.25 * k * math.sqrt(0.5), 2.0, 2.0), **box,
                 until=1.5),
            # up to the ceiling and just there
            Case(f"thrown disc on ceiling, grazing {name}", (0.0, -0.5 - 0.25 * k - 0.5 * g * t * t, 0.5, g * t), **box,
                 gravity=g, until=0.8),
        ]
    return all_cases


# --- the table ------------------------------------------------------------------------------------------------------

HEAD = """#pragma once

#include <array>

// Written by tests/reference/roots.py: first times of contact in 100 digits, rounded to doubles. Don't edit.
// clang-format off
namespace carom::test {

// A disc B meets a body A: a disc if disc_radius > 0, else a box. SI units; doubles as hexadecimal, so exact.
struct ContactReference {
  const char* name;
  double b[4];         // position and velocity of B
  double b_radius;
  double a[4];         // position and velocity of A
  double disc_radius;
  double box[2];       // width and height
  double angle;
  bool fixed;
  bool driven;         // else it flies, unless it is fixed
  double swing[4];     // amplitude x, y, angular frequency and phase of a driven A
  double gravity;      // downwards
  double until;        // how long to look
  double time;         // of the first contact; negative: none
  double closing;      // speed then
};

"""


def hexes(numbers):
    return "{" + ", ".join(float(x).hex() for x in numbers) + "}"


def main():
    rows = []
    for c in cases():
        time, closing = first_contact(c)
        when = "-1.0, 0.0" if time is None else f"{nstr(time, 22)}, {nstr(closing, 22)}"
        rows.append(
            f'  {{"{c.name}",\n   {hexes(c.b)}, {float(c.radius).hex()},\n   {hexes(c.a)}, {float(c.disc).hex()}, '
            f"{hexes(c.box)}, {float(c.angle).hex()},\n   {str(c.fixed).lower()}, {str(c.driven).lower()}, "
            f"{hexes(c.swing)}, {float(c.gravity).hex()}, {float(c.until).hex()},\n   {when}}},")
    print(HEAD + f"inline constexpr std::array<ContactReference, {len(rows)}> kContactReferences = {{{{")
    print("\n".join(rows))
    print("}};\n\n}  // namespace carom::test\n// clang-format on")


if __name__ == "__main__":
    main()
