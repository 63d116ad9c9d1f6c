"""diff()."""

from __future__ import annotations

from verisim import _core

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os
    from collections.abc import Mapping
    from typing import Any


class Difference:
    """How far a picture is from a reference: `status` ("exact", "match" or "differ") and its `reason`; the figures in
    `metrics` (docs/comparison.md), those that are asked for most as attributes; `heat_map`. True if they match."""

    def __init__(self, metrics: dict[str, Any], status: str, reason: str, heat_map: _core.Picture | None) -> None:
        self.metrics = metrics
        self.status = status
        self.reason = reason
        self.heat_map = heat_map

    @property
    def max_abs(self) -> float:
        """Largest difference of a channel, in 8-bit units."""
        return float(self.metrics["max_abs"])

    @property
    def rmse(self) -> float:
        """Root mean square difference, in 8-bit units."""
        return float(self.metrics["rmse"])

    @property
    def psnr(self) -> float:
        """In dB; 999 for equal pictures."""
        return float(self.metrics["psnr"])

    @property
    def ssim(self) -> float:
        """Mean structural similarity."""
        return float(self.metrics["ssim_mean"])

    @property
    def flip(self) -> float:
        """Mean LDR-FLIP."""
        return float(self.metrics["flip_mean"])

    @property
    def within_1_pct(self) -> float:
        """Percentage of pixels that are at most 1/255 away in every channel."""
        return float(self.metrics["within_1_pct"])

    def __bool__(self) -> bool:
        return self.status in ("exact", "match")

    def __repr__(self) -> str:
        return f"<verisim.{type(self).__name__}: {self.status}{': ' * bool(self.reason)}{self.reason}, RMSE {self.rmse:.3g}>"

    def _repr_html_(self) -> str:
        from verisim._html import image, table

        figures = {name: self.metrics[name] for name in ("max_abs", "rmse", "psnr", "within_1_pct", "ssim_mean", "flip_mean")}
        return table({"status": self.status, "reason": self.reason, **figures}) + (image(self.heat_map) if self.heat_map else "")


def diff(
    reference: Any,
    picture: Any,
    *,
    antialiased: bool = False,
    thresholds: Mapping[str, float] | None = None,
    gain: float = 16,
) -> Difference:
    """Compares two pictures of one size: Picture, names of files, arrays of uint8, uint16 or floats (linear light).

    antialiased: differences of 2/255 are allowed where 1/255 would be. thresholds in the place of the usual rules:
    {"max_rmse": 1.5, "min_within_1_pct": 99}. gain: factor for the differences in the heat map. Raises ValueError when the sizes
    differ.
    """
    return Difference(*_core.diff(reference, picture, antialiased, dict(thresholds or {}), gain))
