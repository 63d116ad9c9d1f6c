"""What every part of the grammar draws from: numbers, vectors, colours, names that are declared, noise of style.

Numbers are round, because people's scenes are: faces that touch are where the order of the programs' decisions shows.
"""
import random

ROUND = ["0", "1", "-1", "0.5", "-0.5", "2", "-2", "1.5", "0.25", "-1.5", ".75", "0.1", "1.0", "3"]
POSITIVE = ["1", "0.5", "0.25", "2", "1.5", ".3", "0.75", "0.2", "0.1", "1.0"]


class Draw:
    """A seeded source of choices, and what has been declared so far by kind."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.declared = {}
        self.serial = 0
        self.odd = self.chance(0.3)  # such scenes try what people seldom write
        self.srgb = False  # may `srgb` be said? Only where assumed_gamma stands before it

    def chance(self, p):
        return self.random.random() < p

    def one(self, *choices):
        return self.random.choice(choices)

    def of(self, choices):
        return self.random.choice(list(choices))

    def some(self, choices, most):
        """Up to `most` of the choices, in any order, now and then one of them twice."""
        choices = list(choices)
        picked = self.random.sample(choices, min(len(choices), self.random.randint(0, most)))
        if picked and self.chance(0.08):
            picked.append(self.of(picked))
        return picked

    def name(self, kind):
        """A declared name of a kind, or None."""
        names = self.declared.get(kind)
        return self.of(names) if names else None

    def new_name(self, kind):
        self.serial += 1
        return f"{kind.title().replace('_', '')}{self.serial}"

    def add(self, kind, name):
        self.declared.setdefault(kind, []).append(name)

    def number(self):
        r = self.random.random()
        if r < 0.75:
            return self.of(ROUND)
        if r < 0.83:
            return f"{self.random.uniform(-2, 2):.3f}"
        if r < 0.9 and self.name("float"):
            return self.name("float")
        return self.one(
            "(1/2)",
            "pi/4",
            "sqrt(2)",
            "-(0.5)",
            "sin(1)",
            "(1+1)*.5",
            "min(1,2)",
            "abs(-1.5)",
            "1e0",
            "(3>2)",
            "(1 ? 0.5 : 2)",
            "vlength(x)",
            "<1,2,3>.x",
            "radians(60)",
            "int(1.7)",
            "mod(5,3)",
            'val("0.5")',
        )

    def positive(self):
        r = self.random.random()
        if r < 0.85:
            return self.of(POSITIVE)
        if r < 0.95:
            return f"{self.random.uniform(0.05, 2):.3f}"
        return self.one("sqrt(2)", "pi/4", "max(0.5,0.25)", "(1/2)")

    def integer(self, low, high):
        return str(self.random.randint(low, high))

    def unit(self):
        return self.one("0", "1", "0.5", "0.25", "0.8", "0.1", ".9", f"{self.random.random():.2f}")

    def comma(self):
        return self.one(",", ",", ", ", ",", " ") if self.odd else ", "

    def triple(self, draw=None):
        draw = draw or self.number
        return f"<{draw()}{self.comma()}{draw()}{self.comma()}{draw()}>"

    def vector(self):
        r = self.random.random()
        if r < 0.7:
            return self.triple()
        if r < 0.78 and self.name("vector"):
            return self.name("vector")
        return self.one(
            "x",
            "y",
            "z",
            "-y",
            "2*x",
            "x+y",
            "-z*0.5",
            "<1,1,1>/2",
            "vnormalize(<1,1,0>)",
            "0",
            "1",
            "x-y",
            "vcross(x,y)",
            "vrotate(x,<0,0,90>)",
            "<0,1>+z",
            "-<1,0,1>",
        )

    def direction(self):
        return self.one("x", "y", "z", "-y", "<1,1,0>", "<1,1,1>", "<0,1,-1>", "-z", "<1,0,2>", "-x")

    def colour(self, transparent=0.1):
        """A colour expression, with or without the word `color`."""
        r = self.random.random()
        word = self.one("", "", "", "color ", "colour ")
        if r < 0.55:
            return f"{word}rgb <{self.unit()},{self.unit()},{self.unit()}>"
        if r < 0.62:
            return f"{word}rgb {self.unit()}"
        if r < 0.62 + transparent:
            return word + self.one(
                f"rgbf <1,{self.unit()},1,{self.unit()}>",
                f"rgbt <1,1,{self.unit()},{self.unit()}>",
                f"rgbft <{self.unit()},1,0.5,0.2,{self.unit()}>",
                f"rgb <1,{self.unit()},0> transmit {self.unit()}",
                f"rgb <1,{self.unit()},0> filter {self.unit()}",
            )
        if r < 0.8 and self.name("colour"):
            return word + self.name("colour")
        return self.one(
            f"color red {self.unit()}",
            f"color red 1 green {self.unit()} blue {self.unit()}",
            "rgb x",
            "rgb x+y*0.5",
            f"{word}rgb <1,0.5,0>*{self.unit()}",
            f"color green 1 red {self.unit()}",
            "rgb 1",
            "rgb <1,1,1>",
            "color rgb <0.2,0.4,0.9>",
            "srgb <0.5,0.6,0.7>" if self.srgb else "rgb 0.7",
            f"color <{self.unit()},0.5,1>",
            "color rgb z",
        )

    def transform(self):
        r = self.random.random()
        if self.odd and self.chance(0.06):
            return f"scale {self.one('1e-3', '1000', '1e5', '<1,1e-3,1>', '-1', '<1,-1,1>', '0.01')}"
        if r < 0.3:
            return f"translate {self.vector()}"
        if r < 0.55:
            return (
                f"rotate {self.one('90*y', '<0,45,0>', '<30,0,0>', 'z*180', '<0,0,90>', '-90*x', '<10,20,30>', 'y*45')}"
            )
        if r < 0.8:
            return f"scale {self.one('0.5', '2', '<1,2,1>', '<0.5,1,1>', '<1,1,-1>', '1.5', '<2,.5,1>', '1', self.positive())}"
        if r < 0.86:
            return self.one(
                "matrix <1,0,0,0,1,0,0,0,1,0,0.5,0>",
                "matrix <1,0.5,0,0,1,0,0,0,1,0,0,0>",
                "matrix <0,1,0,1,0,0,0,0,1,0,0,0>",
            )
        if r < 0.93 and self.name("transform"):
            name = self.name("transform")
            return self.one(f"transform {name}", f"transform {{ {name} }}", f"transform {{ {name} inverse }}")
        return f"transform {{ {self.transform()} {self.transform()} {self.one('', 'inverse')} }}"

    def transforms(self, most=2):
        return " ".join(self.transform() for _ in range(self.random.choice([0, 0, 1, 1, most])))
