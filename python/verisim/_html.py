"""What notebooks show."""

from __future__ import annotations

import base64
import html

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from verisim._core import Picture
    from verisim.errors import Diagnostic


def image(picture: Picture) -> str:
    data = base64.b64encode(picture.png()).decode()
    return f'<img src="data:image/png;base64,{data}" width="{picture.width}" height="{picture.height}">'


def listing(diagnostics: Iterable[Diagnostic]) -> str:
    return "".join(f"<pre>{html.escape(str(d))}</pre>" for d in diagnostics)


def table(rows: Mapping[str, Any]) -> str:
    cells = "".join(f"<tr><th style='text-align:left'>{html.escape(k)}</th><td>{html.escape(text(v))}</td></tr>" for k, v in rows.items())
    return f"<table>{cells}</table>"


def tree(value: Any, title: str) -> str:
    """Nested values, to be opened."""
    items = value.items() if isinstance(value, dict) else enumerate(value)
    simple = {str(k): v for k, v in items if not is_nested(v)}
    items = value.items() if isinstance(value, dict) else enumerate(value)
    nested = "".join(tree(v, f"{k}: {summary(v)}") for k, v in items if is_nested(v))
    return f"<details><summary>{html.escape(title)}</summary><div style='margin-left:1em'>{table(simple)}{nested}</div></details>"


def is_nested(value: Any) -> bool:
    return isinstance(value, dict) or isinstance(value, list) and any(isinstance(v, (dict, list)) for v in value)


def summary(value: Any) -> str:
    if isinstance(value, list):
        return f"{len(value)}"
    return next((str(value[key]) for key in ("kind", "type", "object", "state") if isinstance(value.get(key), str)), "")


def text(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else ", ".join(map(text, value)) if isinstance(value, (list, tuple)) else str(value)
