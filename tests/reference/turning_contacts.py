#!/usr/bin/env python3
"""Reference values of presets in which a body turns about a contact: block-on-incline (tipping), rocking-block,
domino-alone and dominoes. Independent of Carom.

    python3 tests/reference/turning_contacts.py

One block that turns about a corner is a pendulum, I phi'' = m g (d/2) sin(phi), with I = m d^2/3 and phi of its
diagonal d from the vertical. Its angles of return are closed forms, its times integrals. A landing of a rocking
block takes the share of G. W. Housner, Bull. Seism. Soc. America 53 (1963) 403.

The row is the model of J. M. J. van Leeuwen, Am. J. Phys. 78 (2010) 721, without friction between dominoes: each is
hinged at its lower right edge; all that have been hit lean on one another, so that a train of k has one angle, q, of
its front; between hits its energy is kept; a hit keeps the train's momentum with respect to q and takes one more
domino in. The corner of one domino touches the face of the next: h sin(phi' - phi) + l cos(phi') = t.

It fails if a preset expects anything else. Needs mpmath (Debian: python3-mpmath).
"""
import json
import math
import sys
from pathlib import Path

from mpmath import acos, asin, atan, cos, mp, mpf, nstr, odefun, quad, sin, sqrt

mp.dps = 30
PRESETS = Path(__file__).resolve().parents[2] / "presets"
faults = 0


def expectations(name):
    return json.loads(next(PRESETS.glob(f"*/{name}.json")).read_text())["expect"]


def compare(what, expected, value, within=mpf("1e-14")):
    global faults
    off = abs(mpf(float(expected["value"])) - value)
    good = off <= within * max(1, abs(value))
    faults += not good
    print(f"  {what:<44} {nstr(value, 17):>24}   {'preset agrees' if good else 'FAULT: ' + repr(expected['value'])}")


def tipping():
    print("block-on-incline, at tan(slope) = 1.005 w/h")
    g, height, slope = mpf(9.81), mpf(0.4), mpf(float(atan(mpf(1) / 2)))
    tips = [e for e in expectations("block-on-incline") if "/method/step" in e.get("with", {})]
    width = mpf(tips[0]["with"]["/bodies/5/shape/width"])
    rate = 3 * g / (2 * sqrt(width**2 + height**2))
    start = slope - atan(width / height)
    motion = odefun(lambda t, y: [y[1], rate * sin(y[0])], 0, [start, mpf(0)])
    for e in tips:
        phi, spin = motion(mpf(e["time"]))
        value = -slope - (phi - start) if e["observable"] == "angle" else -spin
        compare(f"{e['observable']} at {e['time']} s", e, value)


def rocking():
    print("rocking-block")
    g, b, h, tilt = mpf(9.81), mpf(0.3) / 2, mpf(1.2) / 2, mpf(0.1)
    alpha, radius = atan(b / h), sqrt(b * b + h * h)
    ratio = 1 - mpf(3) / 2 * sin(alpha) ** 2

    def fall(tilt):
        """From rest at this angle to the upright; s^2 is the angle gone through, so that nothing is singular."""
        start, rate = alpha - tilt, 3 * g / (4 * radius)
        return quad(lambda s: s / sqrt(rate * sin(start + s * s / 2) * sin(s * s / 2)), [0, sqrt(tilt)])

    # What a landing does, by angular momentum about the new corner: I' w' = (I_c - m (b^2 - h^2)) w.
    inertia = (b * b + h * h) / 3
    assert abs(ratio - (inertia + h * h - b * b) / (inertia + h * h + b * b)) < mpf("1e-25")
    rocks = [e for e in expectations("rocking-block") if e["reduction"] in ("minimum", "maximum")]
    swings = [e for e in rocks if e["observable"] == "angle"]
    side = 1
    lands = [fall(tilt)]
    for k, e in enumerate(swings):
        tilt = alpha - acos(cos(alpha) + ratio**2 * (cos(alpha - tilt) - cos(alpha)))
        side = -side
        compare(f"swing {k + 1}", e, side * tilt)
        lands.append(lands[-1] + 2 * fall(tilt))
    first = sqrt(3 * g / (2 * radius) * (cos(alpha - mpf(0.1)) - cos(alpha)))
    spins = [e for e in rocks if e["observable"] == "spin"]
    compare("spin before the first landing", spins[0], -first)
    compare("spin before the second landing", spins[1], ratio * first)
    moments = [e for e in expectations("rocking-block") if e["reduction"] == "at" and "with" not in e]
    compare("spin at the first landing", moments[0], -first)
    compare("just before which it is", {"value": moments[0]["time"]}, lands[0], mpf("1e-10"))
    compare("spin at the second landing", moments[1], ratio * first)
    compare("just before which it is", {"value": moments[1]["time"]}, lands[1], mpf("1e-10"))
    compare("time of the fifth landing", {"value": moments[2]["time"]}, lands[4])


def alone():
    print("domino-alone")
    g, h, t = mpf(9.81), mpf(0.5), mpf(0.1)
    d, alpha = sqrt(h * h + t * t), atan(t / h)
    bound = sqrt(3 * g * (d - h) / d**2)
    e = expectations("domino-alone")
    turn = alpha - acos(cos(alpha) + (mpf("0.8") * bound) ** 2 * d / (3 * g))
    compare("returns at, with 0.8 of the bound", e[0], -turn)
    w = lambda x: sqrt((mpf("1.5") * bound) ** 2 - 3 * g / d * (cos(alpha - x) - cos(alpha)))
    time = quad(lambda x: 1 / w(x), [0, alpha, 1])
    compare("time to 1 rad, with 1.5 of the bound", {"value": e[-1]["time"]}, time)


def row():
    print("dominoes")
    g, h, t, gap, count = 9.81, 0.5, 0.1, 0.25, 12
    inertia = (h * h + t * t) / 3
    hit = math.asin((gap - t) / h)

    def train(q, k):
        """Angles of the k that lean, the front first, and their derivatives by q."""
        angle, by_q = [q], [1.0]
        for _ in range(k - 1):
            u = (gap * math.cos(angle[-1]) - t) / h
            by_q.append(by_q[-1] * (1 - gap * math.sin(angle[-1]) / h / math.sqrt(1 - u * u)))
            angle.append(angle[-1] + math.asin(u))
        return sum(g / 2 * (h * math.cos(a) + t * math.sin(a)) for a in angle), inertia * sum(x * x for x in by_q)

    def times(n):
        w = 2 * math.sqrt(3 * g * (math.hypot(h, t) - h) / (h * h + t * t))
        now, found = 0.0, []
        for k in range(1, count + 1):
            potential, mass = train(0.0, k)
            energy = potential + 0.5 * mass * w * w

            def rate(q):
                potential, mass = train(q, k)
                return math.sqrt(2 * (energy - potential) / mass)

            weights = [1 if i in (0, n) else 4 if i % 2 else 2 for i in range(n + 1)]
            now += sum(c / rate(hit * i / n) for i, c in enumerate(weights)) * hit / n / 3
            found.append(now)
            _, mass = train(hit, k)
            w = rate(hit) * mass / (mass + inertia)
        return found

    found = times(400)
    print(f"  halving the intervals of Simpson's rule moves the last time by {abs(found[-1] - times(200)[-1]):.1g} s")
    for e in expectations("dominoes"):
        if e["reduction"] != "at":
            continue
        k = int(e["bodies"][0].split("-")[1])
        compare(f"angle of domino {k} at its hit", e, -asin(mpf(gap - t) / mpf(h)), mpf("1e-12"))
        scale = 2 if "with" in e else 1
        compare(f"time of its hit{', g four times' if scale == 2 else ''}", {"value": e["time"]},
                mpf(found[k - 1] / scale), mpf("1e-12"))


def main():
    tipping()
    rocking()
    alone()
    row()
    print(f"\n{faults} faults" if faults else "\nall agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
