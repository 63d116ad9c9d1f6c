"""check()."""

from __future__ import annotations

from verisim import _core
from verisim._job import asked, job

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Unpack

    from verisim._job import Event, Options, Scene


class Check:
    """A scene without errors: the number of its `objects`, `warnings`, what it said by `debug`, the `files` that were read; and, when
    they are asked for, the evaluated scene as a `tree` and a `picture`."""

    def __init__(self, job: _core.Job, cancel: Callable[[], bool] | None) -> None:
        self.objects, self.warnings, self.debug, self.files = _core.check(job, cancel)
        self._job = job
        self._tree: dict[str, Any] | None = None
        self._picture: _core.Picture | None = None

    @property
    def tree(self) -> dict[str, Any]:
        """Dicts and lists as docs/dump.md describes them."""
        if self._tree is None:
            self._tree = _core.tree(self._job)
        return self._tree

    @property
    def picture(self) -> _core.Picture:
        if self._picture is None:
            self._picture = _core.render(self._job, [], None, None)
        return self._picture

    def __repr__(self) -> str:
        return f"<verisim.Check: no errors, {len(self.warnings)} warnings, {self.objects} objects>"

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
    return Check(job(scene, width, height, **options), asked(cancel))
