#!/usr/bin/python3
"""Print a random valid scene (spec section 9) as JSON.

    random_scene.py SEED [--kind billiards|level|mixed]

The same seed and kind always give the same scene. Without --kind the seed chooses one. Scenes have 2 to 40 balls;
balls may overlap each other but never an obstacle or a solid edge.
"""
import argparse
import json
import math
import random

KINDS = ("billiards", "level", "mixed")
SIDES = ("left", "right", "bottom", "top")
MAX_BALLS = 40


class Maker:
    def __init__(self, seed, kind):
        self.rng = random.Random("%s/%s" % (seed, kind))
        self.kind = kind
        rng = self.rng
        self.decimals = rng.choice((None, None, 3, 2, 1, 0))     # None: all the digits
        self.balls = []
        self.obstacles = []
        self.holes = []
        self.edges = {side: "solid" for side in SIDES}
        self.gravity = 0

    # ---- numbers

    def num(self, value):
        if self.decimals is None:
            return value
        if self.decimals == 0:
            return round(value)
        return round(value, self.decimals)

    def uniform(self, low, high):
        return self.num(self.rng.uniform(low, high))

    def chance(self, p):
        return self.rng.random() < p

    # ---- is the ball well placed?

    def fits(self, x, y, r):
        solid = {side: self.edges[side] == "solid" for side in SIDES}
        if solid["left"] and x - r < 0 or solid["bottom"] and y - r < 0:
            return False
        if solid["right"] and (x + r > self.width or x > self.width - r):
            return False
        if solid["top"] and (y + r > self.height or y > self.height - r):
            return False
        for ob in self.obstacles:
            h, reach = ob.get("height", 120), ob.get("radius", 12) + r
            dx, dy = x - ob["x"], y - h
            if y < h:
                if abs(dx) < reach:
                    return False
            elif dx * dx + dy * dy < reach * reach or math.sqrt(dx * dx + dy * dy) < reach:
                return False
        return True

    # ---- balls

    def radius(self):
        if self.one_radius is not None and self.chance(0.9):
            return self.one_radius
        return max(self.uniform(3, 18), 1)

    def velocity(self):
        rng = self.rng
        kind = rng.choice(self.speeds)
        if kind == "rest":
            return 0, 0
        speed = {"slow": 40, "launch": 2000, "fast": 12000, "extreme": 99990}[kind] * rng.random()
        axis = rng.random()
        if axis < 0.1:
            return self.num(rng.choice((-1, 1)) * speed), 0
        if axis < 0.2:
            return 0, self.num(rng.choice((-1, 1)) * speed)
        angle = rng.uniform(0, 2 * math.pi)
        return self.num(speed * math.cos(angle)), self.num(speed * math.sin(angle))

    def add(self, x, y, r, velocity=None, exact=False):
        """Adds the ball if it is well placed. exact: do not round the position."""
        if len(self.balls) >= self.target:
            return False
        if not exact:
            x, y = self.num(x), self.num(y)
        if not self.fits(x, y, r):
            return False
        vx, vy = self.velocity() if velocity is None else velocity
        self.balls.append({"x": x, "y": y, "vx": vx, "vy": vy, "radius": r})
        return True

    def place(self):
        """A place somewhere in the area; now and then beyond an open edge."""
        rng = self.rng
        x, y = rng.uniform(0, self.width), rng.uniform(0, self.height)
        if self.chance(0.05):
            if self.edges["left"] == "open":
                x = rng.uniform(-30, 5)
            elif self.edges["right"] == "open":
                x = self.width + rng.uniform(-5, 30)
        if self.edges["top"] == "open" and self.chance(0.1):
            y = self.height + rng.uniform(-10, 200)
        if self.edges["bottom"] == "open" and self.chance(0.1):
            y = rng.uniform(-100, 10)
        return x, y

    def anywhere(self):
        r = self.radius()
        for _ in range(100):
            if self.add(*self.place(), r):
                return

    def cluster(self):
        """Many balls in little room."""
        x, y = self.place()
        size = self.rng.uniform(5, 60)
        for _ in range(self.rng.randint(3, 15)):
            self.add(x + self.rng.uniform(-size, size), y + self.rng.uniform(-size, size), self.radius())

    def triangle(self):
        """Rows of balls, touching, nearly touching or overlapping."""
        x, y = self.place()
        r = self.radius()
        pitch = 2 * r * self.rng.choice((0.8, 0.95, 1.0, 1.005, 1.01, 1.015, 1.02, 1.03))
        moving = self.chance(0.3)
        for row in range(self.rng.randint(2, 8)):
            for i in range(row + 1):
                self.add(x + row * pitch * math.sqrt(3) / 2, y + (i - row / 2) * pitch, r,
                         None if moving else (0, 0), exact=self.chance(0.9))

    def grid(self):
        """Square lattice: equal heights, equal distances."""
        x, y = self.num(self.place()[0]), self.num(self.place()[1])
        r = self.radius()
        pitch = 2 * r * self.rng.choice((0.9, 1.0, 1.01, 1.02))
        for row in range(self.rng.randint(1, 4)):
            for column in range(self.rng.randint(1, 5)):
                self.add(x + column * pitch, y + row * pitch, r, exact=True)

    def same_centre(self):
        x, y = self.place()
        x, y = self.num(x), self.num(y)
        for _ in range(self.rng.choice((2, 2, 2, 3, 4))):
            self.add(x, y, self.radius(), exact=True)

    def twin(self):
        """A ball at the centre of one that is already there."""
        if self.balls:
            other = self.rng.choice(self.balls)
            self.add(other["x"], other["y"], other["radius"] if self.chance(0.5) else self.radius(), exact=True)

    def floor_row(self):
        """Balls at rest on the bottom edge."""
        x = self.place()[0]
        for _ in range(self.rng.randint(1, 6)):
            r = self.radius()
            lift = self.rng.choice((1, 1, 1, 1.005, 1.01, 1.02))
            self.add(self.num(x), r * lift, r, (0, 0), exact=True)
            x += 2 * r * self.rng.choice((1.0, 1.01, 1.02, 1.3))

    def stack(self):
        """A column or a pyramid standing on the bottom edge."""
        x = self.num(self.place()[0])
        r = self.radius()
        pitch = 2 * r * self.rng.choice((1.0, 1.005, 1.01, 1.015, 1.02))
        if self.chance(0.5):
            for level in range(self.rng.randint(2, 7)):
                self.add(x, r + level * pitch, r, (0, 0), exact=True)
        else:
            rows = self.rng.randint(2, 5)
            for level in range(rows):
                for i in range(rows - level):
                    self.add(x + (i + level / 2) * pitch, r + level * pitch * math.sqrt(3) / 2, r, (0, 0), exact=True)

    def on_cap(self):
        """A ball on the round end of an obstacle, on its top or a little aside."""
        if not self.obstacles:
            return
        ob = self.rng.choice(self.obstacles)
        r = self.radius()
        reach = (ob.get("radius", 12) + r) * self.rng.choice((1.0, 1.001, 1.01, 1.015, 1.02, 1.03))
        angle = math.pi / 2 + self.rng.choice((0, 0, self.rng.uniform(-1.6, 1.6)))
        x = ob["x"] if angle == math.pi / 2 else ob["x"] + reach * math.cos(angle)
        y = ob.get("height", 120) + reach * (1 if angle == math.pi / 2 else math.sin(angle))
        self.add(x, y, r, None if self.chance(0.3) else (0, 0), exact=True)

    def at_wall(self):
        """A ball beside an obstacle, going towards it."""
        if not self.obstacles:
            return
        ob = self.rng.choice(self.obstacles)
        r = self.radius()
        side = self.rng.choice((-1, 1))
        x = ob["x"] + side * (ob.get("radius", 12) + r + self.rng.choice((0, 0.5, 5, 20)))
        speed = self.num(self.rng.uniform(0, 3000))
        self.add(x, self.rng.uniform(r, max(ob.get("height", 120), r)), r, (-side * speed, 0), exact=self.chance(0.5))

    def near_hole(self):
        """A ball over the rim of a hole (or straight over its centre)."""
        if not self.holes:
            return
        hole = self.rng.choice(self.holes)
        r = self.radius()
        far = 0 if self.chance(0.1) else self.rng.uniform(0, hole.get("radius", 16) * 1.2)
        angle = self.rng.uniform(0, 2 * math.pi)
        self.add(hole["x"] + far * math.cos(angle), hole["y"] + far * math.sin(angle), r)

    # ---- the world around them

    def size(self):
        if self.chance(0.4):
            self.width, self.height = 800, 400
        else:
            self.width, self.height = self.uniform(200, 1200), self.uniform(150, 700)

    def add_holes(self, classic):
        w, h = self.width, self.height
        if classic:
            inset = 10
            self.holes = [{"x": x, "y": y, "radius": 16} for y in (inset, h - inset) for x in (inset, w / 2, w - inset)]
            return
        for _ in range(self.rng.randint(1, 6)):
            self.holes.append({"x": self.uniform(0, w), "y": self.uniform(0, h), "radius": max(self.uniform(4, 40), 1)})

    def add_obstacles(self):
        for _ in range(self.rng.randint(1, 5)):
            self.obstacles.append({"x": self.uniform(0, self.width),
                                   "height": max(self.uniform(10, 0.8 * self.height), 1),
                                   "radius": max(self.uniform(3, 30), 1)})
        if self.chance(0.2):             # two that stand close together
            other = self.rng.choice(self.obstacles)
            self.obstacles.append({"x": self.num(other["x"] + self.rng.uniform(-50, 50)),
                                   "height": other["height"], "radius": other["radius"]})
        for ob in self.obstacles:
            if self.chance(0.15):
                del ob["height"]
            if self.chance(0.15):
                del ob["radius"]

    def make(self):
        rng = self.rng
        self.size()
        self.one_radius = max(self.uniform(4, 16), 1) if self.chance(0.5) else 10 if self.chance(0.6) else None
        self.target = rng.choice((rng.randint(2, 8), rng.randint(5, 20), rng.randint(15, MAX_BALLS), MAX_BALLS))
        level = self.kind == "level"
        mixed = self.kind == "mixed"
        self.speeds = rng.choice((("rest", "slow", "launch"), ("rest", "rest", "launch"), ("launch",),
                                  ("rest", "launch", "fast"), ("rest", "launch", "fast", "extreme"), ("extreme",)))
        if level or mixed and self.chance(0.75):
            self.gravity = rng.choice((100, 200, 300, 500, 981, 9.81, self.num(rng.uniform(1, 2000))))
            self.edges["left"] = self.edges["right"] = "open"
            self.edges["top"] = rng.choice(("open", "open", "solid"))
        if mixed or level and self.chance(0.2):
            for side in SIDES:
                if self.chance(0.4):
                    self.edges[side] = rng.choice(("open", "solid"))
            self.edges["bottom"] = "open" if self.chance(0.06) else "solid"
        if self.kind == "billiards" and self.chance(0.05):
            self.edges[rng.choice(("left", "right", "top"))] = "open"
        if self.kind == "billiards" and self.chance(0.85) or mixed and self.chance(0.5):
            self.add_holes(self.chance(0.6))
        if level and self.chance(0.85) or mixed and self.chance(0.6):
            self.add_obstacles()

        lead = None                      # the role of ball 0, if it is the cue ball or the projectile
        if self.chance(0.7):
            lead = {"billiards": "cue", "level": "projectile", "mixed": rng.choice(("cue", "projectile"))}[self.kind]

        builders = [self.anywhere, self.cluster, self.cluster, self.triangle, self.grid, self.same_centre, self.twin]
        if self.holes:
            builders += [self.near_hole] * 2
        if self.obstacles:
            builders += [self.on_cap] * 2 + [self.at_wall] * 2
        if self.gravity:
            builders += [self.floor_row, self.floor_row, self.stack, self.stack]
        while not self.balls:
            self.anywhere()              # ball 0, the lead if there is one
        if lead and self.chance(0.7):    # usually on its way to the others
            speed = {"slow": 40, "rest": 500, "launch": 2000, "fast": 12000, "extreme": 99990}[rng.choice(self.speeds)]
            angle = rng.uniform(0, 2 * math.pi)
            self.balls[0]["vx"] = self.num(speed * math.cos(angle))
            self.balls[0]["vy"] = self.num(speed * math.sin(angle))
        for _ in range(400):
            if len(self.balls) >= self.target:
                break
            rng.choice(builders)()
        while len(self.balls) < 2:
            self.anywhere()
        return self.scene(lead)

    def scene(self, lead):
        rng = self.rng
        breakable = {"billiards": 0.1, "level": 0.95, "mixed": 0.7}[self.kind]
        breakable = self.chance(breakable)
        usual_solidity = rng.choice((50, 300, 1000, 5000, 30000))
        first = self.balls[0]
        if lead == "cue" and self.chance(0.7) and self.fits(first["x"], first["y"], 8):
            first["radius"] = 8
        for i, ball in enumerate(self.balls):
            if i == 0 and lead:
                ball["role"] = lead
            elif self.chance(0.8):
                ball["role"] = "red" if self.kind == "billiards" else rng.choice(("enemy", "enemy", "neutral", "red"))
            role = ball.get("role", "neutral")
            if breakable and self.chance(0.05 if role == "projectile" else 0.8):
                if self.chance(0.2):
                    ball["solidity"] = rng.choice((1, 10, 200000, self.num(rng.uniform(1, 5000)) or 1))
                else:
                    ball["solidity"] = usual_solidity
            if ball["radius"] == (8 if role == "cue" else 10) and self.chance(0.5):
                del ball["radius"]
            for key in ("vx", "vy"):
                if ball[key] == 0 and self.chance(0.5):
                    del ball[key]
        scene = {"carom": 1}
        if self.chance(0.5):
            scene["name"] = "random %s" % self.kind
        scene["width"], scene["height"] = self.width, self.height
        if any(v == "open" for v in self.edges.values()) or self.chance(0.5):
            leave_out = self.chance(0.3)
            scene["edges"] = {side: v for side, v in self.edges.items() if v == "open" or not leave_out}
        if self.chance(0.7):
            scene["friction"] = rng.choice((0.995, 0.995, 0.995, 1, 1, 1, 0.999, 0.999, 0.98, self.num(rng.uniform(0.5, 1)) or 1))
        if self.gravity or self.chance(0.3):
            scene["gravity"] = self.gravity
        if self.chance(0.3):
            scene["hole_pull"] = rng.choice((100000, 50000, 1000, 250000))
        if self.chance(0.4):
            scene["damage_per_speed"] = rng.choice((4, 4, 1, 0.5, 10))
        if self.chance(0.5) and breakable:
            scene["damage_threshold"] = rng.choice((0, 10, 50, 200, 1000, self.num(rng.uniform(0, 500))))
        if self.chance(0.3):
            scene["throws"] = rng.randint(1, 6)
        if self.holes:
            for hole in self.holes:
                if hole["radius"] == 16 and self.chance(0.5):
                    del hole["radius"]
            scene["holes"] = self.holes
        elif self.chance(0.3):
            scene["holes"] = []
        if self.obstacles:
            scene["obstacles"] = self.obstacles
        scene["balls"] = self.balls
        return scene


def random_scene(seed, kind=None):
    if kind is None:
        kind = random.Random("kind of %s" % seed).choice(KINDS)
    return Maker(seed, kind).make()


def main():
    parser = argparse.ArgumentParser(description="print a random valid scene")
    parser.add_argument("seed", type=int, metavar="SEED")
    parser.add_argument("--kind", choices=KINDS)
    args = parser.parse_args()
    print(json.dumps(random_scene(args.seed, args.kind)))


if __name__ == "__main__":
    main()
