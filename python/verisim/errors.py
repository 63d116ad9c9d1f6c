"""What can go wrong, and where."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from verisim._core import Picture


class Error(Exception):
    """All errors of verisim's own."""


class Diagnostic:
    """A message about a scene. `str()` shows it with its line, what is meant underlined."""

    file: str
    line: int  #: from 1; 0: the whole file
    column: int  #: from 1, in bytes; 0: the whole line
    length: int  #: bytes that are meant
    severity: str  #: "error", "unsupported", "possible error" or "warning"
    code: str  #: `verisim check --explain CODE` tells more
    message: str
    advice: str  #: what may be done; may be empty
    source: str  #: the line
    trail: list[str]  #: includes and macro calls that led there
    related: list[dict[str, Any]]  #: other places: message, file, line, column, length
    fix: dict[str, Any] | None = None  #: title, file, offset, length, text: what corrects it without doubt

    def __init__(self, values: dict[str, Any], text: str) -> None:
        self.__dict__.update(values)
        self._text = text

    @property
    def span(self) -> tuple[int, int]:
        """The first column that is meant and the one after the last."""
        return self.column, self.column + max(self.length, 1)

    def __str__(self) -> str:
        return self._text.rstrip("\n")

    def __repr__(self) -> str:
        return f"<{self.file}:{self.line}:{self.column}: {self.severity}: {self.message} [{self.code}]>"


class SceneError(Error):
    """The scene has errors: all that were found are in `diagnostics`; file, line ... are those of the first."""

    def __init__(self, diagnostics: list[Diagnostic]) -> None:
        super().__init__(diagnostics)
        self.diagnostics = diagnostics

    @property
    def file(self) -> str:
        return self.diagnostics[0].file

    @property
    def line(self) -> int:
        return self.diagnostics[0].line

    @property
    def column(self) -> int:
        return self.diagnostics[0].column

    @property
    def span(self) -> tuple[int, int]:
        return self.diagnostics[0].span

    @property
    def code(self) -> str:
        return self.diagnostics[0].code

    @property
    def message(self) -> str:
        return self.diagnostics[0].message

    def __str__(self) -> str:
        return "\n".join(str(d) for d in self.diagnostics)


class Unsupported(SceneError):
    """The scene uses something that verisim does not have."""


class Cancelled(Error):
    """`cancel` asked to stop. `picture` has what was done until then, or is None."""

    def __init__(self, picture: Picture | None = None) -> None:
        super().__init__("cancelled")
        self.picture = picture


class LimitExceeded(Error):
    """A limit ended the render; the message says which one."""


class OracleMissing(Error):
    """There is no POV-Ray to compare with; the message says what to install."""
