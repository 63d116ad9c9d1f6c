"""The extension module. Job and the functions are behind those of the package."""

import os
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from verisim.errors import Diagnostic

version: str

class Plane:
    @property
    def __array_interface__(self) -> dict[str, Any]: ...

class Picture:
    """A rendered picture. As a buffer and for numpy.asarray(): the samples of a PNG file of 8 bits, uint8 of the shape (height,
    width, channels), row 0 at the top, without a copy."""

    def __init__(self, array: Any) -> None:
        """A picture of uint8 samples, (height, width) or (height, width, channels)."""
    @property
    def __array_interface__(self) -> dict[str, Any]: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def channels(self) -> int: ...
    @property
    def pixels(self) -> npt.NDArray[np.uint8]:
        """(height, width, channels): what a PNG file holds. Of one channel: (height, width)."""
    @property
    def radiance(self) -> npt.NDArray[np.float32]:
        """(height, width, 3): colours before gamma and rounding, as the scene computes them; linear light with assumed_gamma 1.
        Multiplied by alpha."""
    @property
    def transmit(self) -> npt.NDArray[np.float32]:
        """(height, width): what shows through, 1 - alpha."""
    @property
    def depth(self) -> npt.NDArray[np.float32]:
        """(height, width): distance from the camera to the centre of the pixel; 1e10 where there is nothing."""
    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """(height, width, 3): in world space, perturbed, towards the viewer; 0 where there is nothing."""
    @property
    def albedo(self) -> npt.NDArray[np.float32]:
        """(height, width, 3): colour of the pigments, without light."""
    @property
    def id(self) -> npt.NDArray[np.uint32]:
        """(height, width): number of the object in the order of the scene, from 1; 0 where there is nothing."""
    @property
    def frame(self) -> int:
        """Number of the frame of an animation; 0 without one."""
    @property
    def clock(self) -> float: ...
    @property
    def debug(self) -> str:
        """What the scene said with #debug, #render and #statistics."""
    @property
    def warnings(self) -> list[Diagnostic]: ...
    @property
    def statistics(self) -> dict[str, float]:
        """Numbers of rays, and seconds."""
    def png(self) -> bytes:
        """The bytes of a PNG file: those that `verisim render` writes."""
    def _repr_png_(self) -> bytes: ...
    def save(self, path: str | os.PathLike[str], *, bits: int = 8, quality: int = 0) -> None:
        """Writes a file, whole or not at all; its ending says what: .png, .jpg, .exr (with the layers), .hdr, .tif, .tga, .bmp or
        .ppm. `bits` a channel, where the format has a choice; `quality` of JPEG, 2 to 100. Raises OSError."""

class Mesh:
    """An object that `mesh2 { ... }` of these arrays would be, for declare={NAME: mesh}; the scene writes `object { NAME texture
    { ... } }`."""

    def __init__(
        self,
        vertices: npt.ArrayLike,
        faces: npt.ArrayLike,
        *,
        normals: npt.ArrayLike | None = None,
        uvs: npt.ArrayLike | None = None,
        normal_faces: npt.ArrayLike | None = None,
        uv_faces: npt.ArrayLike | None = None,
        inside: Sequence[float] | None = None,
    ) -> None:
        """vertices (n, 3); faces (m, 3), indices of vertices; normals (n, 3) and uvs (n, 2), of the vertices unless normal_faces
        and uv_faces (m, 3) say otherwise; inside: a vector, for a solid in CSG. Float64 and uint32 arrays are taken as they are,
        others are converted. Raises ValueError for wrong shapes and indices."""
    @property
    def vertices(self) -> int:
        """How many there are."""
    @property
    def faces(self) -> int:
        """How many there are."""

class Job:
    name: str
    text: bytes | None
    settings: str
    width: int
    height: int
    antialias: bool
    antialias_threshold: float
    antialias_depth: int
    antialias_method: int
    adaptive: bool
    quality: int
    alpha: bool
    threads: int
    seed: int
    replay: bool
    path_samples: int
    include_path: list[str]
    folder: str
    allow_read: list[str]
    allow_write: list[str]
    clock: float
    clock_on: bool
    frame: int
    initial_frame: int
    final_frame: int
    initial_clock: float
    final_clock: float
    clock_delta: float
    max_steps: int
    max_tokens: int
    max_depth: int
    max_file_bytes: int
    max_memory_bytes: int
    def __init__(self) -> None: ...
    def declare(self, name: str, value: Any) -> None: ...
    def add_file(self, name: str, content: Any) -> None: ...

_Asked = Callable[[], bool] | None

def render(job: Job, layers: Sequence[str], on_progress: Callable[[float], object] | None, cancel: _Asked) -> Picture: ...
def check(job: Job, cancel: _Asked) -> tuple[int, list[Diagnostic], str, list[str]]: ...
def tree(job: Job) -> dict[str, Any]: ...
def explain(
    job: Job, x: float, y: float, cancel: _Asked
) -> tuple[list[dict[str, Any]], str, tuple[float, float, float], tuple[int, ...]]: ...
def draw(job: Job, x: float, y: float, azimuth: float, elevation: float, cancel: _Asked) -> str: ...
def diff(
    reference: Any, picture: Any, antialiased: bool, thresholds: dict[str, float], gain: float
) -> tuple[dict[str, Any], str, str, Picture]: ...
def compare(
    job: Job, switches: Sequence[str], use_cache: bool, cancel: _Asked
) -> tuple[dict[str, Any], Picture | None, Picture | None, Picture | None, str]: ...
