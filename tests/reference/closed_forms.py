#!/usr/bin/env python3
"""The closed forms behind the expectations of the preset files, checked against small simulations of their own.

    python3 tests/reference/closed_forms.py [PRESET ...]

For each experiment: its formulas, evaluated in 50 digits with the numbers of the preset file (every number is
taken as the double that Carom reads); the same quantities from a simulation that knows nothing of the formulas:
event by event with roots in closed form, linear springs by the exponential of a matrix, a disc gas in doubles. It
fails if a formula and its simulation differ by more than the line says, or if the preset expects anything else
than the formula. Statistical values have no digits to compare; their line says how far theory and simulation are
apart, and by how many standard errors.

Takes about two minutes. Independent of Carom. Needs mpmath and numpy (Debian: python3-mpmath, python3-numpy).
"""
import json
import math
import random
import sys
from pathlib import Path

import numpy
from mpmath import mp, mpf, inf, pi, sqrt, sin, cos, tan, asin, acos, atan, atan2, exp, ceil, floor, nstr, expm, matrix, ellipk, odefun, quad

mp.dps = 50
PRESETS = Path(__file__).resolve().parents[2] / "presets"


# --- preset files ---------------------------------------------------------------------------------------------------


def number(x):
    return [number(y) for y in x] if isinstance(x, list) else mpf(float(x))


class Preset:
    def __init__(self, name):
        self.file = next(PRESETS.glob(f"*/{name}.json"))
        self.json = json.loads(self.file.read_text())
        self.expect = self.json["expect"]
        self.gravity = -number(self.json["gravity"][1])
        self.duration = number(self.json["duration"])

    def body(self, name):
        b = next(b for b in self.json["bodies"] if b["name"] == name)
        return Body(b)

    def e(self, name):
        m = next(m for m in self.json["materials"] if m["name"] == name)
        return number(m["restitution"])

    def force(self, name):
        return next(f for f in self.json["forces"] if f.get("name") == name)


class Body:
    def __init__(self, json_body):
        self.x, self.y = number(json_body["position"])
        self.u, self.v = number(json_body.get("velocity", [0, 0]))
        self.spin = number(json_body.get("spin", 0))
        self.m = number(json_body.get("mass", 0))
        self.r = number(json_body.get("shape", {}).get("radius", 0))
        self.width = number(json_body.get("shape", {}).get("width", 0))
        self.height = number(json_body.get("shape", {}).get("height", 0))
        self.angle = number(json_body.get("angle", 0))
        self.drive = {k: number(v) for k, v in json_body.get("drive", {}).items()}


class Report:
    """Collects the values that a preset expects, in the order of its file."""

    def __init__(self, name):
        self.preset = Preset(name)
        self.name = name
        self.values = []
        self.faults = 0
        print(f"\n{name}")

    def fault(self, text):
        self.faults += 1
        print(f"  FAULT: {text}")

    def value(self, what, formula, simulated=None, within=mpf("1e-30")):
        """One expected value: its closed form, and how far the simulation is from it."""
        self.values.append(formula)
        line = f"  {what:<58} {nstr(formula, 17):>24}"
        if simulated is not None:
            difference = abs(formula - simulated)
            line += f"   simulated: {nstr(difference, 2)} off"
            if not difference <= within * max(1, abs(formula)):
                self.fault(f"{what}: {nstr(formula, 20)} by the formula, {nstr(simulated, 20)} simulated")
        print(line)

    def agree(self, what, formula, simulated, within=mpf("1e-30")):
        """A formula that the preset does not quote."""
        self.value(what, formula, simulated, within)
        self.values.pop()

    def statistical(self, what, theory, samples, bias=0.0):
        """Theory beside the mean of independent runs; `bias` is the share that finite size may take."""
        mean = float(numpy.mean(samples))
        error = float(numpy.std(samples, ddof=1) / math.sqrt(len(samples)))
        off = mean - float(theory)
        print(f"  {what:<58} {float(theory):>24.6g}   simulated: {off / float(theory):+.2%}, {off / error:+.1f} "
              f"standard errors")
        if abs(off) > 4 * error + bias * abs(float(theory)):
            self.fault(f"{what}: {float(theory)} by theory, {mean} +- {error} simulated")

    def measured(self, what):
        """A value of the preset that no formula gives."""
        self.values.append(None)
        print(f"  {what:<58} (measured)")

    def compare(self):
        expected = [e["value"] for e in self.preset.expect]
        if len(expected) != len(self.values):
            self.fault(f"the preset has {len(expected)} expectations, here are {len(self.values)}")
        for i, (a, b) in enumerate(zip(expected, self.values)):
            # The last digit of a double: the same number may be written a rounding apart.
            if b is not None and abs(mpf(float(a)) - b) > mpf("3e-16") * abs(b) + mpf("1e-40"):
                self.fault(f"/expect/{i} has {a!r}, the formula gives {nstr(b, 17)}")
        return self.faults


# --- simulations ----------------------------------------------------------------------------------------------------


def run_line(x, v, m, e, a=None, until=inf, most=10**9, stop=None):
    """Points on a line, in their order; masses may be infinite. e[i] is the restitution between i and i + 1, a[i]
    a constant acceleration. Returns the impacts as (time, i, positions, velocities after) and the final state."""
    n, t, impacts = len(x), mpf(0), []
    x, v = [mpf(k) for k in x], [mpf(k) for k in v]
    a = [mpf(0)] * n if a is None else [mpf(k) for k in a]

    def move(dt):
        for i in range(n):
            x[i] += v[i] * dt + a[i] * dt * dt / 2
            v[i] += a[i] * dt

    def meeting(i):
        d, w, b = x[i + 1] - x[i], v[i + 1] - v[i], a[i + 1] - a[i]
        if d <= 0 and w < 0:
            return mpf(0)
        if b == 0:
            return -d / w if w < 0 else inf
        if d <= 0:
            return -2 * w / b if b < 0 and w > 0 else inf
        root = w * w - 2 * b * d
        if root < 0 or (w >= 0 and b > 0):
            return inf
        return 2 * d / (-w + sqrt(root)) if b > 0 or w <= 0 else (w + sqrt(root)) / -b

    while len(impacts) < most:
        dt, i = min((meeting(i), i) for i in range(n - 1))
        if t + dt > until or dt == inf:
            break
        move(dt)
        x[i + 1] = x[i]
        t += dt
        wi, wk = (mpf(0) if m[k] == inf else 1 / m[k] for k in (i, i + 1))
        j = (1 + e[i]) * (v[i] - v[i + 1]) / (wi + wk)
        v[i] -= wi * j
        v[i + 1] += wk * j
        impacts.append((t, i, list(x), list(v)))
        if stop is not None and stop(impacts[-1]):
            break
    if until < inf:
        move(until - t)
    return impacts, x, v


def run_spring(m1, m2, k, c, s, w, release):
    """Two masses on a spring with stretch s and rate w. Advances until release(s, w) changes its sign: the time, the
    shares of s, and the rate then. By the exponential of the matrix of x1, x2, v1, v2, without the formulas."""
    matrix4 = matrix([[0, 0, 1, 0], [0, 0, 0, 1], [-k / m1, k / m1, -c / m1, c / m1], [k / m2, -k / m2, c / m2, -c / m2]])
    start = matrix([0, s, 0, w])

    def at(t):
        y = expm(matrix4 * t) * start
        return y[1] - y[0], y[3] - y[2]

    step = sqrt(m1 * m2 / ((m1 + m2) * k)) / 8
    low = step / 8  # past the start, where the spring has just engaged
    while release(*at(low)) * release(*at(low + step)) > 0:
        low += step
    high = low + step
    before = release(*at(low)) > 0
    for _ in range(150):
        middle = (low + high) / 2
        low, high = (middle, high) if (release(*at(middle)) > 0) == before else (low, middle)
    return low, at(low)


def collide(m1, m2, v1, v2, normal, e=1):
    """The velocities after a smooth impact; vectors as pairs."""
    closing = (v1[0] - v2[0]) * normal[0] + (v1[1] - v2[1]) * normal[1]
    j = (1 + e) * closing / (1 / m1 + 1 / m2)
    return ([v1[i] - j / m1 * normal[i] for i in (0, 1)], [v2[i] + j / m2 * normal[i] for i in (0, 1)])


class DiscGas:
    """Equal smooth discs in a box, event by event in doubles: each disc knows its next impact."""

    def __init__(self, x, v, radius, half, restitution=1.0):
        self.x, self.v, self.r, self.half, self.e = x.copy(), v.copy(), radius, half, restitution
        self.n, self.t = len(x), 0.0
        self.time = numpy.full(self.n, numpy.inf)
        self.partner = numpy.full(self.n, -1)
        self.mutual = self.walls = 0
        self.wall_impulse = 0.0  # of unit masses
        for i in range(self.n):
            self.foresee(i)

    def foresee(self, i):
        with numpy.errstate(divide="ignore", invalid="ignore"):
            to_wall = numpy.where(self.v[i] > 0, self.half - self.r - self.x[i], -self.half + self.r - self.x[i])
            wall = numpy.where(self.v[i] != 0, to_wall / self.v[i], numpy.inf)
            axis = int(numpy.argmin(wall))
            best, partner = max(0.0, wall[axis]), -1 - axis
            d, u = self.x - self.x[i], self.v - self.v[i]
            b = (d * u).sum(1)
            uu = (u * u).sum(1)
            root = b * b - uu * ((d * d).sum(1) - 4 * self.r**2)
            dt = numpy.where((b < 0) & (root > 0), (-b - numpy.sqrt(numpy.maximum(root, 0))) / uu, numpy.inf)
        dt[i] = numpy.inf
        k = int(numpy.argmin(dt))
        if dt[k] < best:
            best, partner = max(0.0, dt[k]), k
        self.time[i], self.partner[i] = self.t + best, partner
        if partner >= 0 and self.time[i] < self.time[partner]:
            left = self.partner[partner]
            self.time[partner], self.partner[partner] = self.time[i], i
            if left >= 0 and left != i and self.partner[left] == partner:
                self.partner[left], self.time[left] = -9, self.t  # to be looked at again

    def advance(self, until):
        while True:
            i = int(numpy.argmin(self.time))
            t, k = self.time[i], self.partner[i]
            if t > until:
                break
            self.x += self.v * (t - self.t)
            self.t = t
            if k == -9:
                self.foresee(i)
                continue
            again = {i}
            if k < 0:
                axis = -1 - k
                self.wall_impulse += (1 + self.e) * abs(self.v[i, axis])
                self.v[i, axis] *= -self.e
                self.walls += 1
            else:
                n = (self.x[k] - self.x[i]) / (2 * self.r)
                j = (1 + self.e) / 2 * ((self.v[i] - self.v[k]) @ n)
                self.v[i] -= j * n
                self.v[k] += j * n
                self.mutual += 1
                again.add(int(k))
            again.update(int(p) for p in numpy.nonzero(numpy.isin(self.partner, list(again)))[0])
            for p in again:
                self.time[p] = numpy.inf
            for p in again:
                self.foresee(p)
        self.x += self.v * (until - self.t)
        self.t = until

    def energy(self):
        return 0.5 * (self.v**2).sum()


# --- springs and pistons --------------------------------------------------------------------------------------------


def explosion():
    r = Report("explosion")
    p = r.preset
    light, heavy, spring = p.body("light cart"), p.body("heavy cart"), p.force("spring")
    k, rest = number(spring["stiffness"]), number(spring["rest_length"])
    d0 = heavy.x - light.x
    x = rest - d0

    def formulas(m1, m2):
        energy = k * x * x / 2
        k1 = energy * m2 / (m1 + m2)
        return energy, k1, energy - k1, pi / 2 * sqrt(m1 * m2 / ((m1 + m2) * k))

    def simulated(m1, m2):
        t, (_, w) = run_spring(m1, m2, k, 0, -x, mpf(0), lambda s, w: s)
        v1, v2 = -w * m2 / (m1 + m2), w * m1 / (m1 + m2)  # no momentum
        return t, v1, v2

    m1, m2 = light.m, heavy.m
    energy, k1, k2, free = formulas(m1, m2)
    t, v1, v2 = simulated(m1, m2)
    r.value("v of the light cart", -sqrt(2 * k1 / m1), v1)
    r.value("v of the heavy cart", sqrt(2 * k2 / m2), v2)
    r.value("K of the light cart", k1, m1 * v1 * v1 / 2)
    r.value("K of the heavy cart", k2, m2 * v2 * v2 / 2)
    r.agree("K1/K2 = m2/m1", m2 / m1, m1 * v1 * v1 / (m2 * v2 * v2))
    r.value("momentum", mpf(0))
    r.value("energy", energy)
    moved = m2 / (m1 + m2) * x
    r.value("x of the light cart at 1 s", light.x - moved - sqrt(2 * k1 / m1) * (1 - free),
            light.x - moved + v1 * (1 - t))
    for other in (1, 99):
        v = simulated(m1, mpf(other))[1]
        r.value(f"K of the light cart, other mass {other}", formulas(m1, mpf(other))[1], m1 * v * v / 2)
    return r


def spring_bumpers():
    r = Report("spring-bumpers")
    p = r.preset
    end = p.duration
    results = {}
    for row, spring in ((1, "bumper 1"), (2, "bumper 2"), (3, "bumper 3")):
        f = p.force(spring)
        a, b = p.body(f["body"]), p.body(f["to"])
        k, c, rest = number(f["stiffness"]), number(f.get("damping", 0)), number(f["rest_length"])
        u, m1, m2 = a.u, a.m, b.m
        mu = m1 * m2 / (m1 + m2)
        w0, zeta = sqrt(k / mu), c / (2 * sqrt(k * mu))
        wd = w0 * sqrt(1 - zeta**2)
        met = (b.x - a.x - rest) / u
        if f["acts"] == "push":
            T = acos(2 * zeta**2 - 1) / (w0 * sqrt(1 - zeta**2))
            release = lambda s, w: k * s + c * w
        else:
            T = pi / (w0 * sqrt(1 - zeta**2))
            release = lambda s, w: s
        e = exp(-zeta * w0 * T)
        stretch = -u / wd * exp(-zeta * w0 * T) * sin(wd * T)
        t, (s, w) = run_spring(m1, m2, k, c, mpf(0), -u, release)

        def outcome(e, T, stretch):
            v2 = (1 + e) * m1 * u / (m1 + m2)
            v1 = (m1 - e * m2) * u / (m1 + m2)
            centre = (m1 * (a.x + u * (met + T)) + m2 * b.x) / (m1 + m2)
            x2 = centre + m1 / (m1 + m2) * (rest + stretch)
            return v1, v2, x2 + v2 * (end - met - T)

        results[row] = (outcome(e, T, stretch), outcome(w / u, t, s), e, mu, u, w0, k, rest, met, m1, m2)
    (v1, v2, x2), (s1, s2, sx), e, mu, u, w0, k, rest, met, m1, m2 = results[1]
    r.value("row 1: v of the target", 2 * m1 * u / (m1 + m2), s2)
    r.values.append(rest - u * sqrt(k * mu) / k)
    half = expm(matrix([[0, 1], [-k / mu, 0]]) * (pi / 2 / w0)) * matrix([0, -u])
    r.agree("row 1: largest force u√(kμ)", u * sqrt(k * mu), -k * half[0])
    moment = next(e["time"] for e in p.expect if e["observable"] == "distance")
    r.agree("row 1: the moment of the largest force", mpf(float(moment)), met + pi / 2 / w0, mpf("1e-15"))
    r.value("row 1: x of the target at last", x2, sx)
    (v1, v2, x2), (s1, s2, sx), e2 = results[2][:3]
    r.value("row 2: v of the target", v2, s2)
    r.value("row 2: v of the cart", v1, s1)
    r.value("row 2: x of the target at last", x2, sx)
    (v1, v2, x2), (s1, s2, sx), e3 = results[3][:3]
    r.value("row 3: v of the target", v2, s2)
    r.value("row 3: x of the target at last", x2, sx)
    r.agree("row 4: the material's e is row 2's", p.e("hard rubber"), e2, mpf("1e-15"))
    r.value("row 4: v of the target", (1 + p.e("hard rubber")) * m1 * u / (m1 + m2), results[2][1][1], mpf("1e-15"))
    r.value("lost to dampers", mu * u * u / 2 * (2 - e2**2 - e3**2))
    r.value("momentum", 4 * m1 * u)
    return r


def bar_between_springs():
    r = Report("bar-between-springs")
    p = r.preset
    energy = mpf(0)
    for name in ("narrow", "wide"):
        bar, spring = p.body(name), p.force(f"{name}, right")
        k, arm = number(spring["stiffness"]), number(spring["point"])[0]
        anchor = number(spring["anchor"])[0]
        inertia = bar.m * (bar.width**2 + bar.height**2) / 12
        omega = sqrt(2 * k * arm * anchor / inertia)
        period = 4 / omega * ellipk(sin(bar.angle / 2) ** 2)

        def rates(_, y):
            """Of angle and spin, by the torques of the two springs."""
            torque = mpf(0)
            for side in (1, -1):
                at = side * arm * cos(y[0]), side * arm * sin(y[0])
                pull = k * (side * anchor - at[0]), -k * at[1]
                torque += at[0] * pull[1] - at[1] * pull[0]
            return [y[1], torque / inertia]

        within = mpf("1e-15")
        with mp.workdps(18):
            swing = odefun(rates, 0, [bar.angle, mpf(0)])
            quarter, whole = swing(period / 4), swing(period)
        r.value(f"{name}: angle after T/4", mpf(0), quarter[0], within)
        r.value(f"{name}: spin after T/4", -2 * omega * sin(bar.angle / 2), quarter[1], within)
        r.value(f"{name}: angle after T", bar.angle, whole[0], within)
        energy += k * (arm**2 + anchor**2 - 2 * arm * anchor * cos(bar.angle))
    r.value("distance of the centres", abs(p.body("narrow").y - p.body("wide").y))
    r.value("energy", energy)
    return r


def moving_piston():
    r = Report("moving-piston")
    p = r.preset
    ball, wall, piston = p.body("ball"), p.body("wall"), p.body("piston")
    left = wall.x + wall.width / 2 + ball.r
    right = piston.x - piston.width / 2 - ball.r

    def simulated(V, most):
        return run_line([left, ball.x, right], [0, ball.u, V], [inf, ball.m, inf], [1, 1], most=most)[0]

    def formulas(V, n):
        """At the n-th hit on the piston, which moves with V: time, place, velocity after."""
        w = [ball.u - 2 * V * i for i in range(n)]  # speeds before each hit; V < 0 comes in
        first = (right - ball.x) / (ball.u - V)
        L1 = right + V * first - left
        L = L1 * (w[0] - V) / (w[-1] - V)
        return (L - (right - left)) / V, left + L, 2 * V - w[-1]

    V = piston.drive["velocity"][0]
    run = simulated(V, 15)
    t1, x1, v1 = formulas(V, 1)
    r.value("v after the first hit", v1, run[0][3][1])
    r.value("time of the first hit", t1, run[0][0])
    t8, x8, v8 = formulas(V, 8)
    r.value("v after the eighth hit", v8, run[14][3][1])
    r.value("x at the eighth hit", x8, run[14][2][1])
    r.value("time of the eighth hit", t8, run[14][0])
    r.value("v by the adiabatic law", ball.u * (right - left) / (right + V * p.duration - left))
    hits = sum(1 for h in simulated(V, 40) if h[1] == 1 and h[0] < p.duration)
    r.agree("hits on the piston", mpf(9), mpf(hits))
    r.value("work of the piston", ball.m / 2 * ((ball.u - 2 * hits * V) ** 2 - ball.u**2))
    run = simulated(-V, 7)
    t4, x4, v4 = formulas(-V, 4)
    r.value("going out: v after the fourth hit", v4, run[6][3][1])
    r.value("going out: x at the fourth hit", x4, run[6][2][1])
    return r


# --- impacts in rows ------------------------------------------------------------------------------------------------


def graded_chain():
    r = Report("graded-chain")
    p = r.preset
    light, heavy = p.body("light 2"), p.body("heavy 2")
    m1, m3, v = light.m, heavy.m, light.u

    def last(masses):
        n = len(masses)
        return run_line(range(n), [v] + [0] * (n - 1), masses, [1] * (n - 1))[2][-1]

    def v3(m2):
        return 4 * m1 * m2 * v / ((m1 + m2) * (m2 + m3))

    best = sqrt(m1 * m3)
    r.value("v without one between", 2 * m1 * v / (m1 + m3), last([m1, m3]))
    r.value("v with the best one between", 4 * m1 * v / (sqrt(m1) + sqrt(m3)) ** 2, last([m1, p.body("middle 2").m, m3]))
    r.value("v with three between", (mpf(2) / 3) ** 4 * v, last([m1, 2 * m1, 4 * m1, 8 * m1, m3]))
    # Golden section on the simulation for the best mass between.
    low, high, g = mpf(1), mpf(16), (sqrt(5) - 1) / 2
    for _ in range(110):
        a, b = high - g * (high - low), low + g * (high - low)
        low, high = (a, high) if last([m1, a, m3]) < last([m1, b, m3]) else (low, b)
    r.value("best mass between", best, low, mpf("1e-20"))
    r.value("largest v", 4 * m1 * v / (sqrt(m1) + sqrt(m3)) ** 2, v3(best))
    r.value("v with 2 kg between", v3(mpf(2)), last([m1, mpf(2), m3]))
    r.value("kinetic energy", 3 * m1 * v * v / 2)
    r.value("momentum", 3 * m1 * v)
    r.value("impacts", mpf(7))
    return r


def pi_billiard():
    r = Report("pi-billiard")
    p = r.preset
    light, heavy, wall = p.body("light"), p.body("heavy"), p.body("wall")
    left = wall.x + wall.width / 2

    def count(ratio):
        return ceil(pi / atan(sqrt(1 / mpf(ratio)))) - 1

    def simulated(M):
        x = [left, light.x - light.r, heavy.x - 2 * light.r - heavy.r]
        return run_line(x, [0, 0, heavy.u], [inf, light.m, M], [1, 1])

    def counted_in_doubles(M):
        """Velocities alone: disc, wall, disc, wall, ..."""
        v, V, n, keep, give = 0.0, -1.0, 0, (M - 1) / (M + 1), 2 / (M + 1)
        while True:
            if v <= V:
                return n
            v, V, n = -keep * v + (1 + keep) * V, keep * V + give * v, n + 1
            if v >= 0:
                return n
            v, n = -v, n + 1

    M = heavy.m
    impacts, _, v = simulated(M)
    theta, n = atan(sqrt(light.m / M)), count(M)
    r.value("impacts for M/m = 100", n, mpf(len(impacts)))
    r.value("v of the heavy one", cos((n + 1) * theta) * heavy.u, v[2])
    r.value("v of the light one", sin((n + 1) * theta) * heavy.u * sqrt(M / light.m), v[1])
    r.value("kinetic energy", M * heavy.u**2 / 2)
    for power in (0, 4, 6, 8, 10, 12):
        ratio = mpf(10) ** power
        found = len(simulated(ratio)[0]) if power <= 6 else counted_in_doubles(float(ratio))
        r.value(f"impacts for M/m = 1e{power}", count(ratio), mpf(found))
    return r


def inelastic_collapse():
    mp.dps = 400
    r = Report("inelastic-collapse")
    p = r.preset
    bodies = [p.body(n) for n in ("left", "middle", "right")]
    x = [bodies[0].x + 2 * bodies[0].r, bodies[1].x, bodies[2].x - 2 * bodies[2].r]

    def run(e, most=300):
        return run_line(x, [b.u for b in bodies], [b.m for b in bodies], [mpf(e)] * 2, most=most)

    # The bound: two impacts, one on either side, multiply the pair of relative velocities by a matrix that has a
    # real positive eigenvalue for e < 7 - 4√3 only.
    def discriminant(e):
        a = (1 + e) / 2
        one, two = matrix([[-e, 0], [a, 1]]), matrix([[1, a], [0, -e]])
        product = two * one
        return (product[0, 0] + product[1, 1]) ** 2 - 4 * (product[0, 0] * product[1, 1] - product[0, 1] * product[1, 0])

    low, high = mpf("0.01"), mpf("0.5")
    for _ in range(200):
        e = (low + high) / 2
        low, high = (e, high) if discriminant(e) > 0 else (low, e)
    r.agree("largest e that collapses, 7 - 4√3", 7 - 4 * sqrt(mpf(3)), low)
    e = p.e("putty")
    impacts = run(e)[0]
    r.agree("e of the file: 300 impacts and no end", mpf(300), mpf(len(impacts)))
    steps = [b[0] - a[0] for a, b in zip(impacts, impacts[1:])]
    hits = next(i + 1 for i, dt in enumerate(steps) if dt < impacts[-1][0] * mpf(2) ** -53)
    r.agree("impacts until doubles can't tell them apart", mpf(58), mpf(hits))
    common = sum(b.m * b.u for b in bodies) / sum(b.m for b in bodies)
    centre = sum(b.m * b.x for b in bodies) / sum(b.m for b in bodies)
    together = impacts[-1][0]
    r.agree("time of the collapse", together, impacts[-2][0], mpf("1e-20"))
    r.agree("place of the collapse", impacts[-1][2][1], centre + common * together, mpf("1e-20"))
    r.measured("impacts until the guard acts")
    for name in ("left", "middle", "right"):
        r.value(f"v of the {name} one", common, impacts[-1][3][("left", "middle", "right").index(name)], mpf("1e-20"))
    r.value("x of the middle one at last", centre + common * p.duration)
    r.value("kinetic energy at last", sum(b.m for b in bodies) * common**2 / 2)
    for e in ("0.075", "0.1"):
        found, _, v = run(float(e))
        r.value(f"e = {e}: impacts", mpf(len(found)))
        if e == "0.1":
            r.value("e = 0.1: v of the left one", v[0])
    for e in ("0.07", "0.0717"):
        found, _, v = run(float(e), 2000)
        r.agree(f"e = {e}: no end within 400 digits", mpf(1), mpf(len(found) > 500))
        r.value(f"e = {e}: v of the middle one", common, v[1], mpf("1e-12"))
    mp.dps = 50
    return r


# --- collisions in the plane ----------------------------------------------------------------------------------------


def heavy_on_light():
    r = Report("heavy-on-light")
    p = r.preset
    heavy, light = p.body("heavy"), p.body("light")
    reach = heavy.r + light.r

    def simulated(b, m2):
        """Velocities after; the light disc is at the origin."""
        normal = (sqrt(1 - (b / reach) ** 2), -b / reach)
        return collide(heavy.m, m2, [heavy.u, mpf(0)], [mpf(0), mpf(0)], normal)

    def deflection(b, m2):
        v = simulated(b, m2)[0]
        return atan2(v[1], v[0])

    def best(m2):
        low, high, g = mpf(0), reach, (sqrt(5) - 1) / 2
        for _ in range(110):
            a, b = high - g * (high - low), low + g * (high - low)
            low, high = (a, high) if deflection(a, m2) < deflection(b, m2) else (low, b)
        return low

    v1, v2 = simulated(heavy.y, light.m)
    m1, m2 = heavy.m, light.m
    r.value("largest deflection", asin(m2 / m1), atan2(v1[1], v1[0]), mpf("1e-15"))
    r.value("speed of the heavy one then", heavy.u * sqrt((m1 - m2) / (m1 + m2)), sqrt(v1[0] ** 2 + v1[1] ** 2))
    r.value("direction of the light one", -asin(heavy.y / reach), atan2(v2[1], v2[0]))
    r.value("largest deflection of all", asin(m2 / m1), deflection(best(m2), m2))
    r.value("best offset", reach * sin(acos(m2 / m1) / 2), best(m2), mpf("1e-20"))
    r.value("m2 = 0.5 kg: largest deflection", asin(mpf("0.5") / m1), deflection(best(mpf("0.5")), mpf("0.5")))
    r.value("kinetic energy", m1 * heavy.u**2)
    return r


def incline_hops():
    r = Report("incline-hops")
    p = r.preset
    ramp, ball, g = p.body("ramp"), p.body("ball"), p.gravity
    theta = -ramp.angle
    normal, along = (sin(theta), cos(theta)), (cos(theta), -sin(theta))
    gap = (ball.x - ramp.x) * normal[0] + (ball.y - ramp.y) * normal[1] - ramp.height / 2 - ball.r
    h = gap / cos(theta)
    period, v = 2 * sqrt(2 * h / g), sqrt(2 * g * h)
    start = (ball.x, ball.y - h)

    # Flights in x and y, the gap's quadratic solved at each.
    t, x, w, hops = mpf(0), [ball.x, ball.y], [mpf(0), mpf(0)], []
    for _ in range(5):
        d = (x[0] - ramp.x) * normal[0] + (x[1] - ramp.y) * normal[1] - ramp.height / 2 - ball.r
        a, b = g * normal[1] / 2, w[0] * normal[0] + w[1] * normal[1]
        dt = (b + sqrt(b * b + 4 * a * d)) / (2 * a)
        x = [x[0] + w[0] * dt, x[1] + w[1] * dt - g * dt * dt / 2]
        w = [w[0], w[1] - g * dt]
        across = w[0] * normal[0] + w[1] * normal[1]
        w = [w[i] - 2 * across * normal[i] for i in (0, 1)]
        t += dt
        hops.append((t, list(x), list(w)))

    def place(n):  # of the n-th impact along the ramp
        return 4 * n * (n - 1) * h * sin(theta)

    r.value("first impact", period / 2, hops[0][0])
    r.value("second impact", 3 * period / 2, hops[1][0])
    r.value("fifth impact", 9 * period / 2, hops[4][0])
    r.value("x of the second", start[0] + place(2) * along[0], hops[1][1][0])
    r.value("x of the fifth", start[0] + place(5) * along[0], hops[4][1][0])
    r.value("y of the fifth", start[1] + place(5) * along[1], hops[4][1][1])
    r.value("vx after the fifth", 9 * v * sin(theta) * along[0] + v * cos(theta) * normal[0], hops[4][2][0])
    r.value("energy", ball.m * g * ball.y)
    lengths = [sum((b[1][i] - a[1][i]) * along[i] for i in (0, 1)) for a, b in zip(hops, hops[1:])]
    for n, length in enumerate(lengths, 1):
        r.agree(f"length of hop {n}, 8nh·sinθ", 8 * n * h * sin(theta), length)
    return r


def rough_bounce():
    r = Report("rough-bounce")
    p = r.preset
    g, e = p.gravity, p.e("wood")
    mu = number(p.json["materials"][0]["kinetic_friction"])
    floor_top = p.body("floor").y + p.body("floor").height / 2

    def simulated(b, u):
        """The impact in 4000 slices of the normal impulse with Coulomb's law in each."""
        vn = sqrt(2 * g * (b.y - b.r - floor_top))
        v, w, slices = u, b.spin * b.r, 4000
        lost, left = mpf(0), (1 + e) * vn  # per mass
        for _ in range(slices):
            s = v + w
            most = mu * left / slices
            j = min(most, abs(s) / 3) * (1 if s > 0 else -1)  # s falls by 3j; slip that has stopped stays so
            v, w = v - j, w - 2 * j
            lost += b.m * j * (s - mpf(3) / 2 * j)
        return v, w / b.r, lost

    def slips(b, u):
        J = mu * (1 + e) * sqrt(2 * g * (b.y - b.r - floor_top))
        s = u + b.spin * b.r
        sign = 1 if s > 0 else -1
        return u - sign * J, b.spin - sign * 2 * J / b.r, b.m * J * (abs(s) - mpf(3) / 2 * J)

    def grips(b, u):
        v = (u - b.spin * b.r / 2) / (1 + mpf(1) / 2)
        return v, -v / b.r, b.m * (u + b.spin * b.r) ** 2 / 6

    a, b = p.body("grips"), p.body("slips")
    bound = 3 * mu * (1 + e) * sqrt(2 * g * (a.y - a.r - floor_top))
    print(f"  bound of the slip: {nstr(bound, 10)} m/s")
    r.value("gripping: v", grips(a, a.u)[0], simulated(a, a.u)[0])
    r.value("gripping: spin", grips(a, a.u)[1], simulated(a, a.u)[1])
    r.value("slipping: v", slips(b, b.u)[0], simulated(b, b.u)[0])
    r.value("slipping: spin", slips(b, b.u)[1], simulated(b, b.u)[1])
    r.value("gripping: v after the second bounce", grips(a, a.u)[0])
    for u, law in ((mpf(2.53), grips), (mpf(2.6), slips)):
        r.value(f"u = {nstr(u, 4)}: v", law(a, u)[0], simulated(a, u)[0])
        r.value(f"u = {nstr(u, 4)}: spin", law(a, u)[1], simulated(a, u)[1])
    r.value("lost to friction", grips(a, a.u)[2] + slips(b, b.u)[2], simulated(a, a.u)[2] + simulated(b, b.u)[2])
    return r


# --- bounces --------------------------------------------------------------------------------------------------------


def stacked_drop():
    r = Report("stacked-drop")
    p = r.preset
    g, top = p.gravity, p.body("floor").y + p.body("floor").height / 2

    def simulated(names, masses, e, until):
        bodies = [p.body(n) for n in names]
        shift, x = mpf(0), [top]
        for b in bodies:  # as points: the radii below taken away
            x.append(b.y - shift - b.r)
            shift += 2 * b.r
        n = len(bodies)
        impacts, y, v = run_line(x, [0] * (n + 1), [inf] + masses, [1] + [e] * (n - 1), [0] + [-g] * n, until=until)
        shift = mpf(0)
        for i, b in enumerate(bodies):
            y[i + 1] += shift + b.r
            shift += 2 * b.r
        return impacts, y[1:], v[1:]

    def chain(masses, e):
        """The velocities of the pairwise impacts from the floor upwards, in units of v."""
        up = [mpf(1)]
        for a, b in zip(masses, masses[1:]):
            up.append(-1 + (1 + e) * a * (up[-1] + 1) / (a + b))
        return up

    at = mpf(0.3)
    low, high = p.body("basketball"), p.body("tennis ball")
    t0 = sqrt(2 * (low.y - low.r - top) / g)
    v = g * t0
    m1, m2 = low.m, high.m
    fall = g * (at - t0)
    rounding = mpf("1e-14")  # 0.12, 0.06, ... are no exact doubles: the balls touch within rounding
    impacts, _, w = simulated(["basketball", "tennis ball"], [m1, m2], 1, at)
    r.value("first impact", t0, impacts[0][0])
    r.value("10:1: v of the upper one at 0.3 s", (m1 - m2 + 2 * m1) * v / (m1 + m2) - fall, w[1], rounding)
    r.value("10:1: v of the lower one at 0.3 s", v - 4 * m2 * v / (m1 + m2) - fall, w[0], rounding)
    e = p.e("felt")
    w = simulated(["basketball 2", "felt ball"], [m1, m2], e, at)[2]
    r.value("e = 0.8: v of the upper one at 0.3 s", (m1 - m2 + 2 * e * m1) * v / (m1 + m2) - fall, w[1], rounding)
    names = [f"tower {i}" for i in (1, 2, 3, 4)]
    masses = [p.body(n).m for n in names]
    last = chain(masses, 1)[-1] * v
    r.value("tower: v at 0.3 s", last - fall, simulated(names, masses, 1, at)[2][-1], rounding)
    t = p.duration - t0
    start = p.body("tower 4").y - g * t0**2 / 2
    r.value("tower: y at last", start + last * t - g * t * t / 2, simulated(names, masses, 1, p.duration)[1][-1],
            rounding)
    wide = [mpf(x) for x in (1e6, 1, 1e-6, 1e-12)]
    w = simulated(names, wide, 1, at)[2][-1]
    print(f"  with ratios of 1e6 the limit 15v is missed by {nstr((15 - chain(wide, 1)[-1]) * v, 3)} m/s")
    r.value("tower: v in the limit", 15 * v - fall, w, mpf("1e-5"))
    third = mpf(0.2)
    w = simulated(["basketball", "tennis ball"], [3 * third, third], 1, mpf(0.21))[2]
    r.value("3:1: v of the lower one", mpf(0), w[0] + g * (mpf(0.21) - t0), rounding)
    r.value("3:1: v of the upper one", 2 * v - fall, w[1] + g * (mpf(0.21) - t0) - fall, rounding)
    r.value("3:1: y of the lower one", top + low.r)
    energy = sum(number(b["mass"]) * g * number(b["position"][1]) for b in p.json["bodies"] if "mass" in b)
    r.value("energy", energy - m1 * m2 / (m1 + m2) / 2 * (1 - e**2) * (2 * v) ** 2)
    return r


def vibrating_table():
    r = Report("vibrating-table")
    p = r.preset
    table, ball, g, e = p.body("table"), p.body("ball"), p.gravity, p.e("rubber")
    w = table.drive["angular_frequency"]
    top = table.y + table.height / 2
    rest = top + ball.r

    def flight(y, v, t, A, phase):
        """The next impact: its time, and place and velocity of the ball then; from a bracket by Newton."""
        gap = lambda s: y + v * s - g * s * s / 2 - rest - A * sin(w * (t + s) + phase)
        rate = lambda s: v - g * s - A * w * cos(w * (t + s) + phase)
        a = mpf("1e-12")
        while gap(a + mpf("0.002")) > 0:
            a += mpf("0.002")
        b = a + mpf("0.002")
        s = b
        for _ in range(100):
            new = s - gap(s) / rate(s)
            if not a <= new <= b:
                new = (a + b) / 2
            a, b = (new, b) if gap(new) > 0 else (a, new)
            if abs(new - s) < mpf(10) ** (3 - mp.dps):
                break
            s = new
        return t + s, y + v * s - g * s * s / 2, v - g * s

    def bounces(A, phase, y, n):
        t, v, found = mpf(0), mpf(0), []
        for _ in range(n):
            t, y, v = flight(y, v, t, A, phase)
            floor_speed = A * w * cos(w * t + phase)
            v = floor_speed - e * (v - floor_speed)
            found.append((t, y, v))
        return found

    def impact_map(A, phi, v):
        """Phase and velocity after an impact to those after the next one."""
        t, _, before = flight(rest + A * sin(phi), v, mpf(0), A, phi)
        speed = A * w * cos(w * t + phi)
        return w * t + phi, speed - e * (before - speed)

    def multipliers(gamma):
        """Eigenvalues of the map at the locked bounce, by differences."""
        A = gamma * g / w**2
        psi = acos(pi * (1 - e) / (1 + e) / gamma)
        v, d = pi * g / w, mpf("1e-18")
        J = [[(impact_map(A, psi + d * i, v + d * k)[q] - impact_map(A, psi - d * i, v - d * k)[q]) / (2 * d)
              for i, k in ((1, 0), (0, 1))] for q in (0, 1)]
        trace, determinant = J[0][0] + J[1][1], J[0][0] * J[1][1] - J[0][1] * J[1][0]
        root = mp.sqrt(trace**2 / 4 - determinant)
        return trace / 2 + root, trace / 2 - root

    lower = pi * (1 - e) / (1 + e)
    upper = sqrt(lower**2 + (2 * (1 + e**2) / (1 + e) ** 2) ** 2)
    print(f"  bounds of the table's acceleration: {nstr(lower, 6)} and {nstr(upper, 6)} g")
    r.agree("at the upper bound a multiplier is -1", mpf(-1), multipliers(upper)[1].real, mpf("1e-15"))
    close = lower * (1 + mpf("1e-8"))  # the map's square root is singular at the bound itself
    r.agree("at the lower bound one tends to +1", mpf(1), multipliers(close)[0].real, mpf("1e-3"))
    for inside in (lower * mpf("1.01"), mpf("0.6"), upper * mpf("0.999")):
        r.agree(f"Γ = {nstr(inside, 4)}: stable", mpf(1), mpf(all(abs(x) < 1 for x in multipliers(inside))))
    r.agree("Γ above the upper bound: unstable", mpf(1), mpf(any(abs(x) > 1 for x in multipliers(upper * mpf("1.001")))))

    mp.dps = 30
    A, phase = table.drive["amplitude"][1], table.drive["phase"]
    run = bounces(A, phase, ball.y, 200)
    locked = pi * g / w
    psi = acos(lower / (A * w**2 / g))
    r.value("v of the locked bounce", locked, run[-1][2], mpf("1e-15"))
    r.value("y of its impacts", rest + A * sin(psi), run[-1][1], mpf("1e-15"))
    r.value("impacts a second", w / (2 * pi), 50 / (run[-1][0] - run[-51][0]), mpf("1e-15"))
    variants = [x.get("with", {}) for x in p.expect]
    settings = [[number(x[k]) for k in ("/bodies/0/drive/amplitude/1", "/bodies/0/drive/phase", "/bodies/1/position/1")]
                for x in variants if x]
    r.value("just above the lower bound: v", locked, bounces(*settings[0], 200)[-1][2], mpf("1e-12"))
    r.value("just below the lower bound: highest", rest + settings[1][0])
    r.value("just below the upper bound: v", locked, bounces(*settings[2], 400)[-1][2], mpf("1e-12"))
    run = bounces(*settings[3], 401)
    r.agree("just above: the hops repeat in pairs", run[398][2], run[400][2], mpf("1e-12"))
    r.value("just above the upper bound: v of one hop", run[399][2])
    r.value("just above the upper bound: v of the other", run[400][2])
    mp.dps = 50
    return r


# --- billiards ------------------------------------------------------------------------------------------------------


def folded(x, v, t, low, high):
    """Triangle wave between two walls, and how many of them were met."""
    width = high - low
    way = x - low + v * t
    met = floor(way / width)
    rest = way - met * width
    return (low + rest if met % 2 == 0 else high - rest), abs(met)


def ball_in_a_box():
    r = Report("ball-in-a-box")
    p = r.preset
    ball, left, low = p.body("ball"), p.body("left wall"), p.body("floor")
    X, Y = -left.x - left.width / 2 - ball.r, -low.y - low.height / 2 - ball.r

    def simulated(u, v, until):
        x, y, t, n = ball.x, ball.y, mpf(0), 0
        while True:
            tx = ((X if u > 0 else -X) - x) / u
            ty = ((Y if v > 0 else -Y) - y) / v
            dt = min(tx, ty)
            if t + dt > until:
                return x + u * (until - t), y + v * (until - t), n
            x, y, t, n = x + u * dt, y + v * dt, t + dt, n + 1
            u, v = (-u, v) if tx < ty else (u, -v)

    def formulas(u, v, t):
        (x, nx), (y, ny) = folded(ball.x, u, t, -X, X), folded(ball.y, v, t, -Y, Y)
        return x, y, nx + ny

    x, y, n = formulas(ball.u, ball.v, p.duration)
    sx, sy, sn = simulated(ball.u, ball.v, p.duration)
    r.value("x", x, sx)
    r.value("y", y, sy)
    r.value("bounces", n, mpf(sn))
    fast = next(e["with"] for e in p.expect if "with" in e)
    u, v = number(fast["/bodies/4/velocity/0"]), number(fast["/bodies/4/velocity/1"])
    until = number(next(e["until"] for e in p.expect if "with" in e))
    x, y, n = formulas(u, v, until)
    sx, sy, sn = simulated(u, v, until)
    r.value("fast: bounces", n, mpf(sn))
    r.value("fast: x", x, sx)
    r.value("fast: y", y, sy)
    r.value("fast: kinetic energy", ball.m * (u * u + v * v) / 2)
    return r


def sinai_billiard():
    r = Report("sinai-billiard")
    p = r.preset

    def cell(ball, obstacle):
        b, o = p.body(ball), p.body(obstacle)
        middle, left, low = p.body("middle wall"), p.body("left wall"), p.body("floor")
        height = -low.y - low.height / 2
        inner, outer = middle.width / 2, -left.x - left.width / 2
        sides = (-outer, -inner) if o.x < 0 else (inner, outer)
        return b, o, (sides[0] + b.r, sides[1] - b.r), (-height + b.r, height - b.r), o.r + b.r

    def simulated(ball, obstacle, until, shift=0, scale=1):
        """A ray in the square with its obstacle: place at `until`, and the obstacle's hits."""
        b, o, X, Y, R = cell(ball, obstacle)
        x, y, u, v = b.x, b.y + shift, b.u, b.v
        t, hits, total = mpf(0), 0, 0
        while True:
            tx = (X[1] - x) / u if u > 0 else (X[0] - x) / u
            ty = (Y[1] - y) / v if v > 0 else (Y[0] - y) / v
            dx, dy = x - o.x, y - o.y
            half, c, uu = dx * u + dy * v, dx * dx + dy * dy - R * R, u * u + v * v
            root = half * half - uu * c
            to = (-half - sqrt(root)) / uu if half < 0 and root > 0 else inf
            dt = min(tx, ty, to)
            if t + dt > until:
                return x + u * (until - t), y + v * (until - t), hits, total
            x, y, t, total = x + u * dt, y + v * dt, t + dt, total + 1
            if to == dt:
                nx, ny = (x - o.x) / R, (y - o.y) / R
                un = u * nx + v * ny
                u, v, hits = u - 2 * un * nx, v - 2 * un * ny, hits + 1
            elif tx < ty:
                u = -u
            else:
                v = -v

    for moment in sorted({float(e["time"]) for e in p.expect if e["reduction"] == "at"}):
        for n in (1, 2):
            x, y, hits, total = simulated(f"ball {n}", f"obstacle {n}", mpf(moment))
            near = simulated(f"ball {n}", f"obstacle {n}", mpf(moment), mpf("1e-25"))
            growth = sqrt((near[0] - x) ** 2 + (near[1] - y) ** 2) / mpf("1e-25")
            print(f"  ball {n} at {moment} s: {hits} hits on the obstacle, neighbours parted {nstr(growth, 3)} times")
            r.value(f"x of ball {n} at {moment} s", x)
            r.value(f"y of ball {n} at {moment} s", y)
    b, o, X, Y, R = cell("ball 1", "obstacle 1")
    area = (X[1] - X[0]) * (Y[1] - Y[0]) - pi * R * R
    speed = sqrt(b.u**2 + b.v**2)
    rate = speed * 2 * R / area
    print(f"  mean free path {nstr(pi * area / (2 * pi * R), 6)} m")
    r.value("hits on obstacle 1 a second", rate)
    r.value("hits on obstacle 2 a second", rate)
    r.value("kinetic energy", b.m * speed**2)
    # Many rays at once, in doubles: hits in a time T, by start.
    rays, T = 4000, 400.0
    rng = numpy.random.default_rng(1)
    half = numpy.array([float(X[1] - X[0]), float(Y[1] - Y[0])]) / 2
    x = rng.uniform(-1, 1, (rays, 2)) * half
    while (inside := (x**2).sum(1) < float(R) ** 2).any():
        x[inside] = rng.uniform(-1, 1, (inside.sum(), 2)) * half
    angle = rng.uniform(0, 2 * math.pi, rays)
    v = float(speed) * numpy.stack([numpy.cos(angle), numpy.sin(angle)], 1)
    left, hits = numpy.full(rays, T), numpy.zeros(rays)
    while (left > 0).any():
        wall = ((numpy.where(v > 0, half, -half) - x) / v)
        axis = wall.argmin(1)
        tw = wall.min(1)
        b, vv = (x * v).sum(1), (v * v).sum(1)
        root = b * b - vv * ((x * x).sum(1) - float(R) ** 2)
        to = numpy.where((b < 0) & (root > 0), (-b - numpy.sqrt(numpy.maximum(root, 0))) / vv, numpy.inf)
        dt = numpy.minimum(numpy.minimum(tw, to), left)
        x += v * dt[:, None]
        left -= dt
        hit = (to <= tw) & (left > 0)
        n = x / float(R)
        v -= numpy.where(hit[:, None], 2 * (v * n).sum(1)[:, None] * n, 0)
        flip = ~hit & (left > 0)
        v[numpy.nonzero(flip)[0], axis[flip]] *= -1
        hits += hit
    r.statistical("hits a second, many rays", rate, hits / T)
    print(f"  standard deviation of the rate in a time T: {numpy.std(hits) / math.sqrt(T):.3g}/√T a second")
    return r


def billiard_break():
    r = Report("billiard-break")
    p = r.preset
    cue, ceiling, outer, inner = (p.body(n) for n in ("left cue", "ceiling", "left wall", "middle wall"))
    balls = [Body(b) for b in p.json["bodies"] if "radius" in b["shape"]]
    rack = [b for b in balls if b.x < 0 and b.v == 0]
    # No ball is faster than the cue ball was, for it had all the energy: after the first impact (of the cue ball's
    # way less than this) the nearest cushion is that far away at least.
    top = ceiling.y - ceiling.height / 2
    left, right = outer.x + outer.width / 2, inner.x - inner.width / 2
    first = min(sqrt((b.x - cue.x) ** 2 + (b.y - cue.y) ** 2) for b in rack) - 2 * cue.r
    room = min(min(b.x - b.r - left, right - b.x - b.r, top - b.y - b.r) for b in rack)
    earliest = (first + room) / cue.v
    moment = next(mpf(float(e["time"])) for e in p.expect if e["reduction"] == "at")
    print(f"  no cushion is met before {nstr(earliest, 4)} s")
    r.agree("the momentum is looked at before that", mpf(1), mpf(moment < earliest))
    pairs = zip(*([b for b in balls if side * b.x > 0] for side in (-1, 1)))
    r.agree("the tables are mirror images", mpf(0), sum(abs(a.x + b.x) + abs(a.y - b.y) for a, b in pairs))
    overlap = min(sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2) - a.r - b.r for a in rack for b in rack if a is not b)
    r.agree("the rack is tight", mpf(0), overlap, mpf("1e-15"))
    r.value("momentum", 2 * cue.m * cue.v)
    for _ in range(2):
        r.value("kinetic energy", cue.m * cue.v**2)
    for _ in range(4):
        r.value("momentum across and angular momentum", mpf(0))
    r.value("one cue ball moved: soon", mpf(0))
    r.measured("one cue ball moved: later")
    return r


# --- gases ----------------------------------------------------------------------------------------------------------


def henderson(N, m, kT, r, width, height):
    """Impact rates and pressure of N discs in a box, with the wall's effect on the density of the middle by scaled
    particle theory: rate between discs, rate with the walls, pressure, share of the area covered."""
    area, around = width * height, 2 * (width + height)
    n = N / area
    for _ in range(60):
        eta = n * math.pi * r * r
        n = N / (area - r * around * (1 - eta) / (1 + eta))
    pressure = n * kT * (1 + eta * eta / 8) / (1 - eta) ** 2
    centres = (width - 2 * r) * (height - 2 * r)
    # Virial theorem: 2NkT = 2PA - (rate)(mean impulse)σ, the mean impulse being √(πmkT).
    mutual = 2 * (pressure * centres - N * kT) / (2 * r * math.sqrt(math.pi * m * kT))
    walls = pressure * (around - 8 * r) / math.sqrt(2 * math.pi * m * kT)
    return mutual, walls, pressure, eta


def gas():
    r = Report("gas")
    p = r.preset
    fast, grid = p.body("fast"), p.json["generators"][0]
    N, radius = grid["columns"] * grid["rows"] + 1, float(fast.r)
    m = 127.32395447351627 * math.pi * radius**2
    E = 0.5 * m * float(fast.u) ** 2
    width, height = 3.0, 2.0
    kT = E / N
    mutual, walls, pressure, eta = henderson(N, m, kT, radius, width, height)
    perimeter = 2 * (width + height) - 8 * radius

    def above(x):
        return (1 - x) ** (N - 1)

    # The exact law: directions of 2N velocity components, all equally likely.
    rng = numpy.random.default_rng(2)
    v = rng.standard_normal((20000, 2 * N))
    share = (v[:, :2] ** 2).sum(1) / (v**2).sum(1)
    for x in (1 / N, 3 / N):
        r.statistical(f"P(K > {x:g} E) on the sphere", above(x), (share > x).astype(float))

    samples = []
    for run in range(6):
        columns, rows = grid["columns"], grid["rows"]
        x = [[float(fast.x), float(fast.y)]] + [
            [grid["origin"][0] + i * grid["spacing"][0] + rng.uniform(-1, 1) * grid["jitter"],
             grid["origin"][1] + k * grid["spacing"][1] + rng.uniform(-1, 1) * grid["jitter"]]
            for k in range(rows) for i in range(columns)]
        start = numpy.zeros((N, 2))
        start[0, 0] = float(fast.u)
        g = DiscGas(numpy.array(x), start, radius, numpy.array([width, height]) / 2)
        g.advance(3.0)
        before = g.mutual, g.walls, g.wall_impulse
        shares = []
        for k in range(200):
            g.advance(3.0 + 0.1 * (k + 1))
            K = 0.5 * (g.v**2).sum(1)
            shares.append([(K > 0.01 * K.sum()).mean(), (K > 0.03 * K.sum()).mean(), (K > 0.0025 * K.sum()).mean()])
        samples.append([(g.mutual - before[0]) / 20, (g.walls - before[1]) / 20, (g.wall_impulse - before[2]) / 20]
                       + list(numpy.mean(shares, 0)))
    samples = numpy.array(samples)
    r.value("energy", mpf(E))
    r.value("E/N", mpf(kT))
    for i, x in ((3, 0.01), (4, 0.03), (5, 0.0025)):
        r.value(f"share of time with K > {x} E", mpf(above(x)))
        r.statistical("  the same", above(x), samples[:, i])
    print(f"  Maxwell's law for the last: {math.exp(-0.125 / kT):.4f}; the middle is covered to {eta:.4f}")
    for i, (what, theory) in enumerate((("impacts within the gas a second", mutual), ("impacts with walls a second", walls),
                                        ("force on the walls", pressure * perimeter))):
        r.value(what, mpf(theory))
        r.statistical("  the same", theory, samples[:, i], 0.03)
    return r


def granular_cooling():
    r = Report("granular-cooling")
    p = r.preset
    grid = p.json["generators"][0]
    N, radius, e = grid["columns"] * grid["rows"], grid["radius"][0], float(p.e("grain"))
    m = grid["density"] * math.pi * radius**2
    width, height = 3.0, 2.0
    kT = m * grid["speed"] ** 2 / 3  # of velocities that are uniform in a square
    mutual, walls, _, eta = henderson(N, m, kT, radius, width, height)
    rate = (1 - e * e) * (mutual + walls) / (2 * N)  # 1/τ
    print(f"  covered to {eta:.4f}, τ = {1 / rate:.4f} s; walls {walls / (mutual + walls):.1%} of the impacts")
    times = [ex["time"] for ex in p.expect if ex["reduction"] == "at"]

    def law(t):
        return N * kT / (1 + rate * t) ** 2

    rng = numpy.random.default_rng(3)
    samples = []
    for run in range(4):
        x = [[grid["origin"][0] + i * grid["spacing"][0] + rng.uniform(-1, 1) * grid["jitter"],
              grid["origin"][1] + k * grid["spacing"][1] + rng.uniform(-1, 1) * grid["jitter"]]
             for k in range(grid["rows"]) for i in range(grid["columns"])]
        v = rng.uniform(-1, 1, (N, 2)) * grid["speed"]
        g = DiscGas(numpy.array(x), v, radius, numpy.array([width, height]) / 2, e)
        found = []
        for t in times:
            g.advance(t)
            found.append(m * g.energy())
        samples.append(found)
    samples = numpy.array(samples)
    for i, t in enumerate(times):
        r.value(f"energy at {t} s", mpf(law(t)))
        r.statistical("  the same", law(t), samples[:, i], 0.04)
    r.value("numerical drift", mpf(0))
    return r


# --- bodies of several shapes ---------------------------------------------------------------------------------------


class Plate:
    """A body of several shapes or of one polygon, homogeneous. Area, centre and inertia (of unit density, about the
    centre) by integrals over slices; corners of boxes and polygons from the centre, in the body's own axes."""

    def __init__(self, json_body):
        shapes = json_body.get("shapes") or [json_body]
        sums = [mpf(0)] * 4  # area, moments of x and y, of x² + y²
        corners = []
        for each in shapes:
            shape, (cx, cy) = each["shape"], number(each["position"] if "shapes" in json_body else [0, 0])
            if shape["type"] == "polygon":
                own = [(cx + x, cy + y) for x, y in number(shape["vertices"])]
                corners += own
                parts = self.triangles(own)
            elif shape["type"] == "box":
                w, h = number(shape["width"]) / 2, number(shape["height"]) / 2
                corners += [(cx + i * w, cy + k * h) for i, k in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                parts = [self.slices(cx, w, cy, lambda x, h=h: h)]
            else:
                r = number(shape["radius"])
                parts = [self.slices(cx, r, cy, lambda x, r=r: sqrt(r * r - x * x))]
            for part in parts:
                sums = [a + b for a, b in zip(sums, part)]
        self.area, mx, my, second = sums
        centre = (mx / self.area, my / self.area)
        self.inertia = second - self.area * (centre[0] ** 2 + centre[1] ** 2)
        self.corners = [(x - centre[0], y - centre[1]) for x, y in corners]

    @staticmethod
    def slices(cx, half, cy, height):
        def integral(f):
            return quad(f, [-half, 0, half])

        return [integral(lambda x: 2 * height(x)), integral(lambda x: 2 * (cx + x) * height(x)),
                integral(lambda x: 2 * cy * height(x)),
                integral(lambda x: 2 * ((cx + x) ** 2 + cy**2) * height(x) + 2 * height(x) ** 3 / 3)]

    @staticmethod
    def triangles(corners):
        """Of the origin and each edge, counted by their sign."""
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
            double = ax * by - ay * bx
            yield [double / 2, double * (ax + bx) / 6, double * (ay + by) / 6,
                   double * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12]

    def lowest(self, angle):
        return min(x * sin(angle) + y * cos(angle) for x, y in self.corners)


def json_body(preset, name):
    return next(b for b in preset.json["bodies"] if b["name"] == name)


class Throw:
    """A plate that flies: its moment at t by formulas, and by steps in which gravity acts half before, half after."""

    def __init__(self, r, name, inertia_share):
        """`inertia_share`: of unit density, by the formula."""
        p = r.preset
        self.body, self.g, plate = p.body(name), p.gravity, Plate(json_body(p, name))
        density = number(json_body(p, name)["density"])
        self.m, self.inertia, self.counted = density * plate.area, density * inertia_share, density * plate.inertia
        b = self.body
        self.t = mpf(next(e["time"] for e in p.expect if e["reduction"] == "at"))
        steps = 1000
        dt, at = self.t / steps, [b.x, b.y, b.angle]
        speed, lowest = [b.u, b.v], inf
        for _ in range(steps):
            lowest = min(lowest, at[1] + plate.lowest(at[2]))
            speed[1] -= self.g * dt / 2
            at = [at[0] + speed[0] * dt, at[1] + speed[1] * dt, at[2] + b.spin * dt]
            speed[1] -= self.g * dt / 2
        if not lowest > 0:
            r.fault(f"{name} has landed by then")
        self.flown, self.speed = at, speed

    def place(self):
        b, t = self.body, self.t
        return b.x + b.u * t, b.y + b.v * t - self.g * t * t / 2, b.angle + b.spin * t

    def energies(self):
        """Of both motions, and of rotation."""
        b = self.body
        turning = self.inertia * b.spin**2 / 2
        return self.m * (b.u**2 + (b.v - self.g * self.t) ** 2) / 2 + turning, turning

    def energies_counted(self):
        turning = self.counted * self.body.spin**2 / 2
        return self.m * (self.speed[0] ** 2 + self.speed[1] ** 2) / 2 + turning, turning


def tumbling_l():
    r = Report("tumbling-l")
    long, _, wide = (mpf(k) for k in (0.6, 0, 0.2))
    five = mpf(217) / 150 * wide**2 * (5 * wide**2)  # of unit density
    throw = Throw(r, "L", five)
    for what, formula, flown in zip(("x", "y", "angle"), throw.place(), throw.flown):
        r.value(what, formula, flown)
    within = mpf("1e-15")  # 0.6 is three times 0.2 but for the rounding of the doubles
    whole, turning = throw.energies()
    counted, counted_turning = throw.energies_counted()
    r.value("kinetic energy", whole, counted, within)
    r.value("½I·ω², I = (217/150)m·a²", turning, counted_turning, within)
    b, (x, y, _) = throw.body, throw.place()
    r.value("L about the origin", throw.m * (x * (b.v - throw.g * throw.t) - y * b.u) + throw.inertia * b.spin,
            throw.m * (throw.flown[0] * throw.speed[1] - throw.flown[1] * throw.speed[0]) + throw.counted * b.spin,
            within)
    r.value("lost in flight", mpf(0))
    return r


def hammer():
    r = Report("hammer")
    handle, head = (each["shape"] for each in json_body(r.preset, "hammer")["shapes"])
    apart = number(json_body(r.preset, "hammer")["shapes"][1]["position"])[0]
    areas = [number(s["width"]) * number(s["height"]) for s in (handle, head)]
    own = [a * (number(s["width"]) ** 2 + number(s["height"]) ** 2) / 12 for a, s in zip(areas, (handle, head))]
    centre = areas[1] * apart / sum(areas)
    inertia = sum(own) + areas[0] * centre**2 + areas[1] * (apart - centre) ** 2
    throw = Throw(r, "hammer", inertia)
    for what, formula, flown in zip(("x", "y", "angle"), throw.place(), throw.flown):
        r.value(what, formula, flown)
    whole, turning = throw.energies()
    counted, counted_turning = throw.energies_counted()
    r.value("½I·ω²", turning, counted_turning)
    r.value("kinetic energy", whole, counted)
    r.value("momentum", throw.m * throw.body.u, throw.m * throw.speed[0])
    return r


def dumb_bell():
    r = Report("dumb-bell")
    p = r.preset
    ball, bell = p.body("ball"), json_body(p, "dumb-bell")
    disc, rod = bell["shapes"][0]["shape"], bell["shapes"][1]["shape"]
    radius, w, h = number(disc["radius"]), number(rod["width"]), number(rod["height"])
    d = number(bell["shapes"][2]["position"])[0]
    M = 2 * pi * radius**2 + w * h
    inertia = 2 * pi * radius**2 * (radius**2 / 2 + d**2) + w * h * (w**2 + h**2) / 12
    plate = Plate(bell)
    r.agree("mass", M, plate.area)
    r.agree("inertia", inertia, plate.inertia)

    def energy(j):
        """After this impulse, with what was counted."""
        v = ball.v - j / ball.m
        return ball.m * v**2 / 2 + j**2 / plate.area / 2 + (j * d) ** 2 / plate.inertia / 2

    # The impulse that keeps the energy, a quadratic in it: by two differences.
    slope, bend = (energy(mpf(1)) - energy(mpf(-1))) / 2, (energy(mpf(1)) + energy(mpf(-1))) / 2 - energy(mpf(0))
    kept = -slope / bend
    j = 2 * ball.v / (1 / ball.m + 1 / M + d**2 / inertia)
    r.value("time of the impact", (-ball.y - radius - ball.r) / ball.v)
    r.value("v of the dumb-bell", j / M, kept / plate.area)
    r.value("its spin", j * d / inertia, kept * d / plate.inertia)
    r.value("v of the ball", ball.v - j / ball.m, ball.v - kept / ball.m)
    r.value("kinetic energy", ball.m * ball.v**2 / 2, energy(kept))
    r.value("L about the origin", ball.m * ball.v * ball.x, ball.m * (ball.v - kept / ball.m) * d + kept * d)
    r.value("lost to restitution", mpf(0))
    r.agree("the far disc goes backwards, M·d² > I", mpf(1), mpf(kept / plate.area < kept * d / plate.inertia * d))
    return r


def cup_catches_a_ball():
    r = Report("cup-catches-a-ball")
    p = r.preset
    ball, cup = p.body("ball"), p.body("cup")
    plate = Plate(json_body(p, "cup"))
    a, h, deep, thick = mpf(0.6), mpf(0.6), mpf(0.1), mpf(0.1)  # outside; the bottom, the walls
    centre = (deep * h * deep / 2 + 2 * thick * (a - deep) * (a + deep) / 2) / (deep * h + 2 * thick * (a - deep))

    def gap(t):
        """Of the ball to the cup's outline."""
        at, corners, nearest = (ball.x + ball.u * t - cup.x, ball.y - cup.y), plate.corners, inf
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
            ex, ey = bx - ax, by - ay
            s = min(mpf(1), max(mpf(0), ((at[0] - ax) * ex + (at[1] - ay) * ey) / (ex * ex + ey * ey)))
            nearest = min(nearest, sqrt((ax + s * ex - at[0]) ** 2 + (ay + s * ey - at[1]) ** 2))
        return nearest - ball.r

    low, high = mpf(0), mpf("0.45")
    if not all(gap(high * k / 900) > 0 for k in range(810)):
        r.fault("the ball touches a side wall")
    for _ in range(150):
        middle = (low + high) / 2
        low, high = (middle, high) if gap(middle) > 0 else (low, middle)
    v1, v2 = collide(ball.m, cup.m, [ball.u, mpf(0)], [mpf(0), mpf(0)], (mpf(-1), mpf(0)), 0)
    both, lost = ball.m * ball.u / (ball.m + cup.m), ball.m * cup.m / (ball.m + cup.m) * ball.u**2 / 2
    # 0.6 - 0.5 is 0.1 but for the rounding of the doubles.
    r.value("time of the impact", (ball.x - ball.r - cup.x - (deep - centre)) / -ball.u, low, mpf("1e-15"))
    r.value("v of the cup", both, v2[0])
    r.value("v of the ball", both, v1[0])
    r.value("lost to restitution", lost, (ball.m * (ball.u**2 - v1[0] ** 2) - cup.m * v2[0] ** 2) / 2)
    r.value("spin of the cup", mpf(0))
    r.value("momentum", ball.m * ball.u, ball.m * v1[0] + cup.m * v2[0])
    return r


EXPERIMENTS = {
    "explosion": explosion,
    "graded-chain": graded_chain,
    "pi-billiard": pi_billiard,
    "stacked-drop": stacked_drop,
    "incline-hops": incline_hops,
    "heavy-on-light": heavy_on_light,
    "rough-bounce": rough_bounce,
    "spring-bumpers": spring_bumpers,
    "bar-between-springs": bar_between_springs,
    "tumbling-l": tumbling_l,
    "hammer": hammer,
    "dumb-bell": dumb_bell,
    "cup-catches-a-ball": cup_catches_a_ball,
    "moving-piston": moving_piston,
    "vibrating-table": vibrating_table,
    "gas": gas,
    "granular-cooling": granular_cooling,
    "inelastic-collapse": inelastic_collapse,
    "sinai-billiard": sinai_billiard,
    "ball-in-a-box": ball_in_a_box,
    "billiard-break": billiard_break,
}


def main():
    names = sys.argv[1:] or EXPERIMENTS
    faults = sum(EXPERIMENTS[name]().compare() for name in names)
    print(f"\n{faults} faults" if faults else "\nall agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
