"""compare()."""

from __future__ import annotations

from verisim import _core, _job
from verisim._diff import Difference

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Unpack

    from verisim._job import Event, Options, Scene


class Comparison(Difference):
    """A Difference between POV-Ray's picture, the `reference`, and verisim's `picture`; all that is known is in `report`, and
    as a page in `html`. `status` may also be "oracle_failed", when POV-Ray cannot render the scene, with a `reason`."""

    def __init__(self, report: dict[str, Any], reference: _core.Picture | None, picture: _core.Picture | None,
                 heat_map: _core.Picture | None, html: str) -> None:  # fmt: skip
        super().__init__(report.get("metrics", {}), report["status"], report.get("reason", ""), heat_map)
        self.report = report
        self.reference = reference
        self.picture = picture
        self.html = html

    def __repr__(self) -> str:
        return super().__repr__() if self.metrics else f"<verisim.Comparison: {self.status}: {self.reason}>"


def compare(
    scene: Scene,
    width: int = 160,
    height: int = 120,
    *,
    use_cache: bool = True,
    cancel: Event | Callable[[], bool] | None = None,
    **options: Unpack[Options],
) -> Comparison:
    """Renders a scene with POV-Ray and with verisim and compares the two, with statistics where the scene is noisy
    (docs/comparison.md). The options are those of render(), as far as POV-Ray can be told them: declared numbers and strings,
    files of bytes. use_cache: POV-Ray's pictures are kept for the next time. Raises OracleMissing, SceneError.
    """
    import os
    import tempfile

    for key, value in (options.get("declare") or {}).items():
        if not _job.value_text(value):
            raise ValueError(f"declare[{key!r}]: POV-Ray takes numbers and strings only")
    with tempfile.TemporaryDirectory(prefix="verisim-") as folder:
        files = options.get("files") or {}
        if hasattr(scene, "read") or _job.is_text(scene) or files:
            scene = spooled(scene, files, options.get("name"), folder)
            options["files"] = {}
            options["include_path"] = [*options.get("include_path", ()), os.getcwd()]
        what = _job.job(scene, width, height, **options)
        _core.check(what, None)
        switches = _job.switches(what, options.get("antialias", False), options.get("antialias_depth", 3),
                                 options.get("antialias_method", 1), options.get("clock"), options.get("declare") or {})  # fmt: skip
        switches += [f"+L{os.path.abspath(path)}" for path in options.get("include_path", ())]
        return Comparison(*_core.compare(what, switches, use_cache, _job.asked(cancel)))


def spooled(scene: Any, files: Any, name: str | None, folder: str) -> str:
    """A scene and its files on disk, for POV-Ray."""
    import os

    for file, content in files.items():
        if not isinstance(content, (bytes, bytearray, str)) or os.path.basename(file) != file:
            raise ValueError(f"files[{file!r}]: POV-Ray reads files: bytes or str, and names without folders")
        with open(os.path.join(folder, file), "wb") as out:
            out.write(content.encode() if isinstance(content, str) else content)
    if hasattr(scene, "read") or _job.is_text(scene):
        text = _job.contents(scene)
    else:
        name = name or os.path.basename(os.fspath(scene))
        with open(scene, "rb") as source:
            text = source.read()
    path = os.path.join(folder, os.path.basename(name or "scene.pov"))
    with open(path, "wb") as out:
        out.write(text)
    return path
