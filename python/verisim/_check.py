"""check()."""

from __future__ import annotations

from verisim import _core
from verisim._job import asked, job

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Unpack

    from verisim._job import Event, Options, Scene
    from verisim.errors import Diagnostic


class Check:
    """A scene without errors: `warnings`, the evaluated scene as a `tree` (docs/dump.md), `files` that were read."""

    def __init__(self, tree: dict[str, Any], warnings: list[Diagnostic], debug: str, files: list[str], job: _core.Job):
        self.tree = tree
        self.warnings = warnings
        self.debug = debug
        self.files = files
        self._job = job
        self._picture: _core.Picture | None = None

    @property
    def picture(self) -> _core.Picture:
        """The scene, rendered when it is first asked for."""
        if self._picture is None:
            self._picture = _core.render(self._job, [], None, None)
        return self._picture

    def __repr__(self) -> str:
        return f"<verisim.Check: no errors, {len(self.warnings)} warnings, {len(self.tree['objects'])} objects>"

    def _repr_html_(self) -> str:
        from verisim._html import listing, tree

        return listing(self.warnings) + tree(self.tree, "scene")


def check(
    scene: Scene,
    width: int = 160,
    height: int = 120,
    *,
    cancel: Event | Callable[[], bool] | None = None,
    **options: Unpack[Options],
) -> Check:
    """Reads a scene without rendering it. Raises SceneError with all that is wrong, Unsupported. The options are those of
    render()."""
    what = job(scene, width, height, **options)
    return Check(*_core.check(what, asked(cancel)), what)
