"""render()."""

from __future__ import annotations

from verisim import _core
from verisim._job import asked, job

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any

    from verisim._job import Event, Scene

LAYERS = ("depth", "normal", "albedo", "id")


def wanted(layers: bool | Iterable[str]) -> list[str]:
    names = list(LAYERS) if layers is True or layers == "all" else [layers] if isinstance(layers, str) else list(layers or ())
    for name in names:
        if name not in LAYERS:
            raise ValueError(f"there is no layer {name!r}; there are {', '.join(LAYERS)}")
    return names


def render(
    scene: Scene,
    width: int = 160,
    height: int = 120,
    *,
    antialias: bool | float = False,
    antialias_depth: int = 3,
    antialias_method: int = 1,
    sampler: str = "povray",
    declare: Mapping[str, Any] | None = None,
    files: Mapping[str, Any] | None = None,
    include_path: Iterable[str | os.PathLike[str]] = (),
    clock: float | None = None,
    quality: int = 9,
    alpha: bool = False,
    layers: bool | Iterable[str] = (),
    threads: int = 0,
    seed: int = 0,
    replay: bool = False,
    path_samples: int = 0,
    name: str | None = None,
    allow_read: Iterable[str | os.PathLike[str]] = (),
    allow_write: Iterable[str | os.PathLike[str]] = (),
    limits: Mapping[str, int] | None = None,
    on_progress: Callable[[float], object] | None = None,
    cancel: Event | Callable[[], bool] | None = None,
) -> _core.Picture:
    """Renders a scene: the picture, and the file it makes, are those of `verisim render`.

    scene: the name of a file, or text (a str with a line break, `{`, `;` or `#`; bytes), or something with read().
    antialias: POV-Ray's threshold, or True for 0.3; antialias_depth 1 to 9, antialias_method 1 or 2 as +R and +AM;
        sampler="adaptive" takes samples until the error is small.
    declare: identifiers and their values: numbers, strings, tuples (vectors and colours), lists (arrays), verisim.Mesh.
    files: what the scene finds under names without looking at the disk: bytes or str as they are; arrays as pixels, (height,
        width[, channels]) of uint8, uint16 or floats; for names ending in .df3 as voxels, (z, y, x).
    include_path: folders for include files and pictures, before the scene's own and the standard ones.
    clock, quality, alpha, seed, replay: +K, +Q, +UA, --seed, --replay. path_samples: paths a pixel, for path tracing.
    layers: of "depth", "normal", "albedo", "id"; True: all.
    threads: 0 for all cores; the picture does not depend on it.
    name: how messages call a scene that is text; its folder is where files are looked for, too.
    allow_read, allow_write: paths below which the scene may read (everything, if empty) and write (in any case: the current
        folder and its own). limits: max_steps, max_tokens, max_depth, max_file_bytes, max_memory_bytes of reading it.
    on_progress: called in this thread with the fraction that is done, now and then.
    cancel: a threading.Event, or a function that returns True, to end it.

    Other Python threads run meanwhile; any number of renders may. Raises SceneError with all mistakes of the scene,
    Unsupported, Cancelled (with what is done), LimitExceeded, and OSError where its file cannot be read.
    """
    what = job(
        scene, width, height, name=name, antialias=antialias, antialias_depth=antialias_depth, antialias_method=antialias_method,
        sampler=sampler, declare=declare, files=files, include_path=include_path, clock=clock, quality=quality, alpha=alpha,
        threads=threads, seed=seed, replay=replay, path_samples=path_samples, allow_read=allow_read, allow_write=allow_write,
        limits=limits,
    )
    return _core.render(what, wanted(layers), on_progress, asked(cancel))
