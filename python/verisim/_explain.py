"""explain()."""

from __future__ import annotations

from verisim import _core
from verisim._job import asked, job

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any, Unpack

    from verisim._job import Event, Options, Scene

    Vector = tuple[float, float, float]


class _Node:
    """A part of the tree: its values are attributes."""

    _parts: dict[str, type[_Node]] = {}  # lists of further nodes

    def __init__(self, values: dict[str, Any]) -> None:
        for name, value in values.items():
            part = self._parts.get(name)
            setattr(self, name, [part(v) for v in value] if part else vector(value))

    def __repr__(self) -> str:
        return f"<{type(self).__name__} " + ", ".join(f"{k}={v!r}" for k, v in vars(self).items() if k not in self._parts) + ">"


def vector(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) and not any(isinstance(v, dict) for v in value) else value


class Light(_Node):
    """A light as a surface sees it."""

    position: Vector
    state: str  #: "lit", "shadow", "behind" or "out of reach"
    distance: float
    arrives: Vector  #: colour, after fading and shadows
    adds: Vector  #: what the surface makes of it
    highlight: Vector  #: a part of what it adds
    blocker: str  #: of a light in shadow: the object
    blocked_at: Vector


class Layer(_Node):
    """A layer of the texture where a ray ends; the first one is the upper."""

    object: str
    point: Vector
    normal: Vector
    bumped: Vector  #: the perturbed normal
    inside: bool
    pigment: Vector
    filter: float
    transmit: float
    above: Vector  #: what upper layers let through
    own: Vector  #: ambient light and emission
    reflects: Vector
    lights: list[Light]
    _parts = {"lights": Light}


class Term(_Node):
    """A term of a ray's colour."""

    what: str
    adds: Vector
    layer: int  #: which one it comes from
    rays: tuple[int, int]  #: which of the rays it comes from: the first, and the one after the last


class Ray(_Node):
    """A ray, what it meets, and the `rays` that are sent out from there. Colours are linear."""

    kind: str  #: "camera", "reflected", "refracted", "transmitted", "gathering", or "cut off": not traced, for a `reason`
    reason: str
    origin: Vector
    direction: Vector
    weight: float
    distance: float | None  #: None: it sees the sky
    crosses: list[dict[str, Any]]  #: every surface along it: distance, object
    layers: list[Layer]
    rays: list[Ray]
    sum: list[Term]  #: what they add is the colour
    color: Vector
    see_through: float
    _parts = {"layers": Layer, "sum": Term}

    def walk(self) -> Iterator[Ray]:
        """This ray and all that follow from it."""
        yield self
        for ray in getattr(self, "rays", ()):
            yield from ray.walk()


Ray._parts["rays"] = Ray


class Explanation:
    """How a pixel came to be: the `tree` of rays, the same as `text`, its linear `color` and the samples `stored` in a file
    of 8 bits."""

    def __init__(self, job: _core.Job, x: float, y: float, cancel: Callable[[], bool] | None) -> None:
        self._rays, self.text, self.color, self.stored = _core.explain(job, x, y, cancel)
        self.x, self.y = x, y
        self.tree = [Ray(ray) for ray in self._rays]
        self._job = job

    @property
    def picture(self) -> _core.Picture:
        """The whole picture, with lines to the pixel from its edges."""
        import numpy

        pixels = numpy.array(_core.render(self._job, [], None, None))
        x, y = round(self.x), round(self.y)
        gap = 2 + max(pixels.shape) // 40
        marked = numpy.zeros(pixels.shape[:2], bool)
        marked[y, :] = marked[:, x] = True
        marked[max(y - gap, 0) : y + gap + 1, max(x - gap, 0) : x + gap + 1] = False
        pixels[marked] = numpy.where(pixels[marked] < 128, 255, 0)
        return _core.Picture(pixels)

    def drawing(self, azimuth: float = 30, elevation: float = 25) -> str:
        """The rays as SVG, in front of the scene, seen from an angle in degrees: (0, 0) looks along +z, (90, 0) along +x, (0, 90)
        down."""
        return _core.draw(self._job, self.x, self.y, azimuth, elevation, None)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<verisim.Explanation of ({self.x:g}, {self.y:g}): {sum(1 for t in self.tree for _ in t.walk())} rays, stored {self.stored}>"

    def _repr_html_(self) -> str:
        from verisim._html import image, tree

        return image(self.picture) + self.drawing() + tree({"rays": self._rays}, repr(self))


def explain(
    scene: Scene,
    x: float,
    y: float,
    width: int = 160,
    height: int = 120,
    *,
    cancel: Event | Callable[[], bool] | None = None,
    **options: Unpack[Options],
) -> Explanation:
    """How the pixel in column x and row y came to be, from 0 at the top left; whole numbers are centres. Without
    anti-aliasing. The options are those of render()."""
    if not (-0.5 <= x <= width - 0.5 and -0.5 <= y <= height - 0.5):
        raise ValueError(f"({x}, {y}) is no pixel of a picture of {width} by {height}")
    options["antialias"] = False
    return Explanation(job(scene, width, height, **options), x, y, asked(cancel))
