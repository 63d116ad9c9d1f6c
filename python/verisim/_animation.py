"""animation()."""

from __future__ import annotations

from verisim import _core
from verisim._job import asked, contents, in_range, job
from verisim._render import wanted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import Unpack

    from verisim._job import Event, FrameOptions, Scene


def animation(
    scene: Scene,
    width: int = 160,
    height: int = 120,
    *,
    frames: int,
    clock: tuple[float, float] = (0, 1),
    cyclic: bool = False,
    layers: bool | Iterable[str] = (),
    on_progress: Callable[[float], object] | None = None,
    cancel: Event | Callable[[], bool] | None = None,
    **options: Unpack[FrameOptions],
) -> Iterator[_core.Picture]:
    """The frames of an animation, rendered one by one as they are asked for: pictures that know their `frame`, from 1, and
    `clock`, from the first value to the second; cyclic: the frame after the last is like the first (+KFF, +KI, +KF, +KC).
    The other options are those of render(); on_progress gets the fraction of each frame.
    """
    first, last = clock
    final = in_range("frames", frames, 1, 1 << 30) + bool(cyclic)
    if hasattr(scene, "read"):
        scene = contents(scene)
    delta = (last - first) / (final - 1) if final > 1 else 0.0
    names = wanted(layers)

    def rendered() -> Iterator[_core.Picture]:
        for number in range(1, frames + 1):
            what = job(scene, width, height, clock=single(first + delta * (number - 1)), **options)
            what.frame, what.initial_frame, what.final_frame = number, 1, final
            what.initial_clock, what.final_clock, what.clock_delta = first, last, delta
            yield _core.render(what, names, on_progress, asked(cancel))

    return rendered()


def single(value: float) -> float:
    """POV-Ray's clock has single precision."""
    import struct

    return float(struct.unpack("f", struct.pack("f", value))[0])
