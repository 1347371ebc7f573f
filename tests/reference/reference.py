#!/usr/bin/python3
"""Reference implementation of the physics in spec.md: slow, literal, standard library only.

    reference.py SCENE --steps N      (SCENE is a JSON file, "-" is stdin)

prints the trace of spec section 9 as JSON Lines, without the "hash" key. Line 0 is the state before the first
step. It exists to be compared bit by bit with the engine, so every expression below is written, and evaluated,
in the order of the text; numbers are binary64 (Python floats) and math.sqrt is the only library function.
The section signs in the comments are those of spec.md.
"""
import argparse
import json
import math
import sys

DT = 0.01            # §1, time step
SEPARATION = 1.01    # §1, separation factor
TOUCHING = 1.02      # §1, touching factor
MAX_SUBSTEPS = 64    # §2

INFINITE = float("inf")


class Ball:
    __slots__ = ("id", "role", "ox", "oy", "vx", "vy", "ax", "ay", "r", "s", "alive")

    def __init__(self, ident, spec):
        self.id = ident
        self.role = spec.get("role", "neutral")
        self.ox = float(spec["x"])
        self.oy = float(spec["y"])
        self.vx = float(spec.get("vx", 0))
        self.vy = float(spec.get("vy", 0))
        self.ax = 0.0
        self.ay = 0.0
        self.r = float(spec.get("radius", 8 if self.role == "cue" else 10))
        self.s = float(spec["solidity"]) if "solidity" in spec else INFINITE
        if self.role == "projectile":    # §5
            self.s = INFINITE
        self.alive = True                # False: pocketed, destroyed or gone; takes part in nothing


class Hole:
    def __init__(self, spec):
        self.x = float(spec["x"])
        self.y = float(spec["y"])
        self.radius = float(spec.get("radius", 16))


class Obstacle:
    def __init__(self, spec):
        self.x = float(spec["x"])
        self.height = float(spec.get("height", 120))
        self.radius = float(spec.get("radius", 12))


def length(x, y):
    return math.sqrt(x * x + y * y)


def unit(x, y):
    """Unit vector along (x, y); (1, 0) when there is no direction (§3: the centres coincide)."""
    d = length(x, y)
    if d == 0.0:
        return 1.0, 0.0
    return x / d, y / d


def overlap(p, q):
    """§2 stage 2: |oq - op|^2 < (rp + rq)^2."""
    dx = q.ox - p.ox
    dy = q.oy - p.oy
    return dx * dx + dy * dy < (p.r + q.r) * (p.r + q.r)


def touch(p, q):
    """§2 stage 2: distance <= 1.02 x the sum of radii."""
    return length(q.ox - p.ox, q.oy - p.oy) <= TOUCHING * (p.r + q.r)


def separate(p, q):
    """§3: put p and q at 1.01 of their radii from g, along u (from p to q)."""
    ux, uy = unit(q.ox - p.ox, q.oy - p.oy)
    gx = (q.r * p.ox + p.r * q.ox) / (p.r + q.r)
    gy = (q.r * p.oy + p.r * q.oy) / (p.r + q.r)
    p.ox = gx - SEPARATION * p.r * ux
    p.oy = gy - SEPARATION * p.r * uy
    q.ox = gx + SEPARATION * q.r * ux
    q.oy = gy + SEPARATION * q.r * uy
    return ux, uy


def deviation(pvx, pvy, qvx, qvy, ux, uy):
    """§3: dv = max(vi.u - vj.u, 0) u."""
    m = max((pvx * ux + pvy * uy) - (qvx * ux + qvy * uy), 0.0)
    return m * ux, m * uy


class World:
    def __init__(self, scene):
        self.width = float(scene["width"])
        self.height = float(scene["height"])
        self.solid = {side: scene.get("edges", {}).get(side, "solid") == "solid"
                      for side in ("left", "right", "bottom", "top")}
        self.friction = float(scene.get("friction", 0.995))
        self.gravity = float(scene.get("gravity", 0))
        self.hole_pull = float(scene.get("hole_pull", 100000))
        self.damage_per_speed = float(scene.get("damage_per_speed", 4))
        self.damage_threshold = float(scene.get("damage_threshold", 0))
        self.holes = [Hole(h) for h in scene.get("holes", [])]
        self.obstacles = [Obstacle(o) for o in scene.get("obstacles", [])]
        self.balls = [Ball(i, b) for i, b in enumerate(scene["balls"])]   # indices 0..n-1, n = len(self.balls)
        # §2: a cue ball or projectile is always ball 0; it keeps that index even while it is out of play.
        self.has_lead = bool(self.balls) and self.balls[0].role in ("cue", "projectile")
        self.steps_done = 0
        self.events = []

    # ------------------------------------------------------------------------------------------ one step (§2)

    def step(self):
        self.events = []
        k = self.substeps()
        h = DT / k
        for n in range(k):
            lead_was_in_play = self.has_lead and self.balls[0].alive
            self.move(h, self.friction if n == k - 1 else 1.0)
            self.pairs()
            if self.gravity > 0.0:
                self.support()
            self.pull_of_holes()
            self.hit_obstacles()
            self.hit_edges()
            self.removal()
            if lead_was_in_play and not self.balls[0].alive:
                break                    # the remaining sub-steps of this step are dropped
        self.steps_done += 1

    def substeps(self):
        """min(64, max(1, ceil(|v| dt / r) over the live balls))."""
        k = 1
        for b in self.balls:
            if b.alive:
                q = length(b.vx, b.vy) * DT / b.r
                if q > MAX_SUBSTEPS:
                    return MAX_SUBSTEPS
                c = int(q)
                if c < q:
                    c += 1
                k = max(k, c)
        return k

    # Stage 1.
    def move(self, h, f):
        for b in self.balls:
            if b.alive:
                b.ox = b.ox + b.vx * h
                b.oy = b.oy + b.vy * h
                b.vx = b.vx * f + b.ax * h
                b.vy = b.vy * f + b.ay * h
                b.ax = 0.0
                b.ay = -self.gravity

    # Stage 2.
    def pairs(self):
        balls = self.balls
        for i in range(len(balls)):
            for j in range(i + 1, len(balls)):
                p, q = balls[i], balls[j]
                if p.alive and q.alive and overlap(p, q):
                    third = self.touches_both(p, q)
                    if third is None:
                        self.two_balls(p, q)
                    else:
                        self.three_balls(p, q, third)

    def touches_both(self, p, q):
        for t in self.balls:
            if t.alive and t is not p and t is not q and touch(t, p) and touch(t, q):
                return t
        return None

    # §3.
    def two_balls(self, p, q):
        ux, uy = separate(p, q)
        dvx, dvy = deviation(p.vx, p.vy, q.vx, q.vy, ux, uy)
        self.exchange(p, q, dvx, dvy)

    # §4.
    def three_balls(self, i, j, k):
        pairs = ((i, j), (j, k), (i, k))
        for p, q in pairs:
            if overlap(p, q):
                separate(p, q)
        dvs = []
        for p, q in pairs:               # positions: after all separations; velocities: before the collision, halved
            ux, uy = unit(q.ox - p.ox, q.oy - p.oy)
            dvs.append(deviation(p.vx / 2, p.vy / 2, q.vx / 2, q.vy / 2, ux, uy))
        for (p, q), (dvx, dvy) in zip(pairs, dvs):
            if p.alive and q.alive:      # §5: a ball destroyed earlier takes no further part
                self.exchange(p, q, dvx, dvy)

    def exchange(self, p, q, dvx, dvy):
        """The pair event, the damage (§5) to p then to q, then the velocities."""
        self.events.append({"kind": "pair", "a": p.id, "b": q.id, "dv": [dvx, dvy]})
        ds = self.damage_per_speed * length(dvx, dvy)
        p_before, q_before = p.s, q.s
        self.damage(p, ds)
        self.damage(q, ds)
        if p.alive and q.alive:
            p.vx, p.vy = p.vx - dvx, p.vy - dvy
            q.vx, q.vy = q.vx + dvx, q.vy + dvy
        elif p.alive:                    # q destroyed: p is deviated by dv' = (s_before / ds) dv
            w = q_before / ds
            p.vx, p.vy = p.vx - w * dvx, p.vy - w * dvy
        elif q.alive:                    # p destroyed
            w = p_before / ds
            q.vx, q.vy = q.vx + w * dvx, q.vy + w * dvy

    # §5.
    def damage(self, b, ds):
        if b.s == INFINITE or ds < self.damage_threshold or not ds > 0.0:
            return
        b.s = b.s - ds
        self.events.append({"kind": "damage", "ball": b.id, "ds": ds, "solidity": b.s})
        if b.s < 0.0:
            b.alive = False
            self.events.append({"kind": "destroyed", "ball": b.id})

    # Stage 3.
    def support(self):
        balls = self.balls
        for i in range(len(balls)):
            for j in range(i + 1, len(balls)):
                p, q = balls[i], balls[j]
                if p.alive and q.alive and touch(p, q):
                    lower, upper = (q, p) if q.oy < p.oy else (p, q)
                    ux, uy = unit(upper.ox - lower.ox, upper.oy - lower.oy)
                    self.hold(upper, ux, uy)

    @staticmethod
    def hold(b, ux, uy):
        """a <- a - min(a.u, 0) u."""
        m = min(b.ax * ux + b.ay * uy, 0.0)
        b.ax = b.ax - m * ux
        b.ay = b.ay - m * uy

    # Stage 4.
    def pull_of_holes(self):
        for index, hole in enumerate(self.holes):
            for b in self.balls:
                if not b.alive:
                    continue
                dx = hole.x - b.ox
                dy = hole.y - b.oy
                dist = length(dx, dy)
                if dist < hole.radius:
                    if dist <= hole.radius - b.r:
                        b.alive = False
                        self.events.append({"kind": "pocketed", "ball": b.id, "hole": index})
                    elif dist > 0.0:     # no pull at D = 0
                        d = (hole.radius - dist) / b.r
                        m = self.hole_pull * d * math.sqrt(max(1.0 - d * d, 0.0))
                        b.ax = b.ax + m * (dx / dist)
                        b.ay = b.ay + m * (dy / dist)

    # Stage 5.
    def hit_obstacles(self):
        for index, ob in enumerate(self.obstacles):
            for b in self.balls:
                if not b.alive:
                    continue
                reach = ob.radius + b.r
                if b.oy < ob.height:
                    if abs(b.ox - ob.x) < reach:
                        self.hit_wall(index, ob, b, reach)
                else:
                    if length(b.ox - ob.x, b.oy - ob.height) < reach:
                        self.hit_cap(index, ob, b, reach)
                    # after a hit the distance is that of the new position
                    if (b.alive and self.gravity > 0.0
                            and length(b.ox - ob.x, b.oy - ob.height) <= TOUCHING * reach):
                        ux, uy = unit(b.ox - ob.x, b.oy - ob.height)
                        self.hold(b, ux, uy)

    def hit_wall(self, index, ob, b, reach):
        if b.ox >= ob.x:
            b.ox = ob.x + reach
            wrong_way = b.vx < 0.0
        else:
            b.ox = ob.x - reach
            wrong_way = b.vx > 0.0
        old = b.vx
        if wrong_way:
            b.vx = -b.vx
        dv = [b.vx - old, 0.0]
        self.events.append({"kind": "wall", "ball": b.id, "obstacle": index, "dv": dv})
        self.damage(b, self.damage_per_speed * length(dv[0], dv[1]))

    def hit_cap(self, index, ob, b, reach):
        ux, uy = unit(b.ox - ob.x, b.oy - ob.height)     # from the cap to the ball
        b.ox = ob.x + SEPARATION * reach * ux
        b.oy = ob.height + SEPARATION * reach * uy
        m = b.vx * ux + b.vy * uy
        dv = [0.0, 0.0]
        if m < 0.0:                      # coming nearer: v <- v - 2 (v.u) u
            dv = [-(2.0 * m * ux), -(2.0 * m * uy)]
            b.vx = b.vx + dv[0]
            b.vy = b.vy + dv[1]
        self.events.append({"kind": "cap", "ball": b.id, "obstacle": index, "dv": dv})
        self.damage(b, self.damage_per_speed * length(dv[0], dv[1]))

    # Stage 6.
    def hit_edges(self):
        for b in self.balls:
            for side in ("left", "right", "bottom", "top"):
                if b.alive:
                    if self.solid[side]:
                        self.solid_edge(b, side)
                    else:
                        self.open_edge(b, side)
            if b.alive and self.gravity > 0.0 and self.solid["bottom"] and b.oy <= SEPARATION * b.r:
                b.ay = max(b.ay, 0.0)

    def solid_edge(self, b, side):
        oldx, oldy = b.vx, b.vy
        if side == "left":
            if not b.ox - b.r < 0.0:
                return
            b.ox = b.r
            if b.vx < 0.0:
                b.vx = -b.vx
        elif side == "right":
            if not b.ox + b.r > self.width:
                return
            b.ox = self.width - b.r
            if b.vx > 0.0:
                b.vx = -b.vx
        elif side == "bottom":
            if not b.oy - b.r < 0.0:
                return
            b.oy = b.r
            if b.vy < 0.0:
                b.vy = -b.vy
        else:
            if not b.oy + b.r > self.height:
                return
            b.oy = self.height - b.r
            if b.vy > 0.0:
                b.vy = -b.vy
        dv = [b.vx - oldx, b.vy - oldy]
        if side == "bottom" and self.gravity > 0.0:
            self.events.append({"kind": "floor", "ball": b.id, "dv": dv})
        else:
            self.events.append({"kind": "cushion", "ball": b.id, "side": side, "dv": dv})
        self.damage(b, self.damage_per_speed * length(dv[0], dv[1]))

    def open_edge(self, b, side):
        if (side == "left" and b.ox + b.r < 0.0) or (side == "right" and b.ox - b.r > self.width):
            b.alive = False
            self.events.append({"kind": "left", "ball": b.id})

    # Stage 7.
    def removal(self):
        balls = self.balls
        for i in range(len(balls) - 1, -1, -1):
            if not balls[i].alive and not (i == 0 and self.has_lead):
                balls[i], balls[-1] = balls[-1], balls[i]
                balls.pop()

    # ------------------------------------------------------------------------------------------ trace (§9)

    def trace_line(self):
        return json.dumps({
            "step": self.steps_done,
            "balls": [{"id": b.id, "x": b.ox, "y": b.oy, "vx": b.vx, "vy": b.vy, "ax": b.ax, "ay": b.ay,
                       "radius": b.r, "solidity": None if b.s == INFINITE else b.s}
                      for b in self.balls if b.alive],
            "events": self.events,
        }, separators=(",", ":"))


def main():
    parser = argparse.ArgumentParser(description="print the reference trace of a scene")
    parser.add_argument("scene", metavar="SCENE", help="scene file (JSON), - for stdin")
    parser.add_argument("--steps", type=int, required=True, metavar="N")
    args = parser.parse_args()
    if args.scene == "-":
        scene = json.load(sys.stdin)
    else:
        with open(args.scene, encoding="utf-8") as file:
            scene = json.load(file)
    world = World(scene)
    print(world.trace_line())
    for _ in range(args.steps):
        world.step()
        print(world.trace_line())


if __name__ == "__main__":
    main()
