"""What the functions have in common: from a scene and options to a job of the library."""

from __future__ import annotations

import os

from verisim import _core

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any, Protocol, TypedDict, Union

    class Readable(Protocol):
        def read(self) -> str | bytes: ...

    class Event(Protocol):
        def is_set(self) -> bool: ...

    Scene = Union[str, bytes, os.PathLike[str], Readable]

    class FrameOptions(TypedDict, total=False):
        """The options of render() that say what is rendered, and how, but for the clock."""

        name: str | None
        antialias: bool | float
        antialias_depth: int
        antialias_method: int
        sampler: str
        declare: Mapping[str, Any] | None
        files: Mapping[str, Any] | None
        include_path: Iterable[str | os.PathLike[str]]
        quality: int
        alpha: bool
        threads: int
        seed: int
        replay: bool
        path_samples: int
        allow_read: Iterable[str | os.PathLike[str]]
        allow_write: Iterable[str | os.PathLike[str]]
        limits: Mapping[str, int] | None

    class Options(FrameOptions, total=False):
        clock: float | None


MAX_PIXELS = 1 << 28
LIMITS = ("max_steps", "max_tokens", "max_depth", "max_file_bytes", "max_memory_bytes")


def is_text(scene: Scene) -> bool:
    """Whether a str or bytes is a scene itself, and not the name of one."""
    return isinstance(scene, bytes) or isinstance(scene, str) and any(c in scene for c in "\n{;#")


def contents(scene: Scene) -> bytes:
    """The text of a scene that is not the name of a file."""
    text = scene if isinstance(scene, (str, bytes)) else scene.read()  # type: ignore[union-attr]
    return text.encode() if isinstance(text, str) else text


def in_range(name: str, value: Any, low: int, high: int) -> int:
    if not low <= value <= high:
        raise ValueError(f"{name} is {low} to {high}, not {value}")
    return int(value)


def job(
    scene: Scene,
    width: int = 160,
    height: int = 120,
    *,
    name: str | None = None,
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
    threads: int = 0,
    seed: int = 0,
    replay: bool = False,
    path_samples: int = 0,
    allow_read: Iterable[str | os.PathLike[str]] = (),
    allow_write: Iterable[str | os.PathLike[str]] = (),
    limits: Mapping[str, int] | None = None,
) -> _core.Job:
    out = _core.Job()
    folders = [os.fspath(folder) for folder in include_path]
    if isinstance(scene, (str, os.PathLike)) and not is_text(scene):
        path = os.fspath(scene)
        with open(path, "rb"):  # raises what open() raises
            pass
        out.name = path
        folders.append(os.path.dirname(path) or ".")
    else:
        out.text = contents(scene)
        out.name = name or "scene.pov"
        out.folder = os.path.dirname(out.name)
    out.include_path = folders

    out.width = in_range("width", width, 1, MAX_PIXELS)
    out.height = in_range("height", height, 1, MAX_PIXELS // out.width)
    out.antialias = antialias is not False and antialias is not None
    out.antialias_threshold = 0.3 if isinstance(antialias, bool) or antialias is None else antialias
    out.antialias_depth = in_range("antialias_depth", antialias_depth, 1, 9)
    out.antialias_method = in_range("antialias_method", antialias_method, 1, 2)
    if sampler not in ("povray", "adaptive"):
        raise ValueError(f"sampler is 'povray' or 'adaptive', not {sampler!r}")
    out.adaptive = sampler == "adaptive"
    out.quality = in_range("quality", quality, 0, 11)
    out.alpha = alpha
    out.threads = in_range("threads", threads, 0, 1024)
    out.seed = seed
    out.replay = replay
    out.path_samples = path_samples
    if clock is not None:
        out.clock, out.clock_on = clock, True
    for key, value in (declare or {}).items():
        out.declare(key, value)
    for key, content in (files or {}).items():
        out.add_file(key, content)
    out.allow_read = [os.fspath(path) for path in allow_read]
    out.allow_write = [os.fspath(path) for path in allow_write]
    for limit, most in (limits or {}).items():
        if limit not in LIMITS:
            raise ValueError(f"there is no limit {limit!r}; there are {', '.join(LIMITS)}")
        setattr(out, limit, most)
    out.settings = " ".join(settings(out, antialias, antialias_depth, antialias_method, clock, declare or {}))
    return out


def switches(job: _core.Job, antialias: bool | float, depth: int, method: int, clock: float | None, declare: Mapping[str, Any]) -> list[str]:
    """The options as POV-Ray's switches, without the size."""
    out = []
    if job.antialias:
        out += [f"+A{'' if antialias is True else number(antialias)}"]
        out += [f"+R{depth}"] * (depth != 3) + [f"+AM{method}"] * (method != 1)
    out += [f"+Q{job.quality}"] * (job.quality != 9) + ["+UA"] * job.alpha
    if clock is not None:
        out.append(f"+K{number(clock)}")
    return out + [f"Declare={key}={value_text(value)}" for key, value in declare.items() if value_text(value)]


def settings(job: _core.Job, antialias: bool | float, depth: int, method: int, clock: float | None, declare: Mapping[str, Any]) -> list[str]:
    """The options as a picture's file tells them: those of `verisim render` called alike."""
    out = [f"Width={job.width}", f"Height={job.height}"]
    if job.antialias:
        out.append("Antialias=on")
        out += [f"Antialias_Threshold={number(antialias).removeprefix('0')}"] * (antialias is not True)
        out += [f"Antialias_Depth={depth}"] * (depth != 3) + [f"Sampling_Method={method}"] * (method != 1)
    out += [f"Quality={job.quality}"] * (job.quality != 9) + ["Output_Alpha=on"] * job.alpha
    if clock is not None:
        out.append(f"Clock={number(clock)}")
    return out + [f"Declare={key}={value_text(value)}" for key, value in declare.items() if value_text(value)]


def number(value: float) -> str:
    return f"{value:.17g}" if float(f"{value:g}") != value else f"{value:g}"


def value_text(value: Any) -> str:
    """A declared value as switches give it; empty where they cannot."""
    if isinstance(value, str):
        return f'"{value}"'
    return number(value) if isinstance(value, (int, float)) else ""


def asked(cancel: Any) -> Any:
    """What is called to learn whether to stop: of an event or a function."""
    return getattr(cancel, "is_set", cancel)
