"""The names of vapory, so that programs written for it run: `from verisim.vapory import *` in the place of `from vapory import *`.

Scenes are built of elements whose arguments are what stands between the braces; nothing is written to disk to render them, and any
number may be rendered at once. What POV-Ray has and this list has not is made by `element("name")`.
"""

from __future__ import annotations

import copy
import os
import re
import sys

import verisim

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import Any

_BLOCKS = """
    background bicubic_patch blob bounded_by box bump_map camera clipped_by color_map colour_map cone contained_by cubic
    cutaway_textures cylinder density density_map difference disc face_indices finish fog function global_settings
    height_field image_map image_pattern interior interior_texture intersection isosurface julia_fractal lathe light_group
    light_source looks_like material material_map media merge mesh mesh2 normal normal_indices normal_map normal_vectors
    object ovus parametric photons pigment pigment_map pigment_pattern plane poly polygon polynomial prism projected_through
    quadric quartic radiosity rainbow scattering sky_sphere slope_map smooth_triangle sor sphere sphere_sweep spline
    subsurface superellipsoid text texture texture_list texture_map torus transform triangle union uv_indices uv_vectors
    vertex_vectors warp
"""


def vectorize(values: Iterable[float]) -> str:
    """A vector of SDL."""
    return "<" + ",".join(format_if_necessary(v) for v in values) + ">"


def format_if_necessary(value: Any) -> str:
    """A value as SDL: sequences of numbers are vectors; elements and strings are what they are."""
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, (str, POVRayElement)):
        return str(value)
    if hasattr(value, "__iter__"):
        return vectorize(value)
    if isinstance(value, int):
        return str(value)
    return repr(float(value)) if hasattr(value, "__float__") else str(value)


def _joined(values: Sequence[Any]) -> str:
    """Arguments on a line each; a number or a vector behind another one is parted from it by a comma, lest `1 -2` be one number."""
    lines, before = [], True
    for value in values:
        words = isinstance(value, (str, POVRayElement))
        lines.append(format_if_necessary(value) if words or before else ", " + format_if_necessary(value))
        before = words
    return "\n".join(lines)


class POVRayElement:
    """A block of SDL: its name is that of the class, its arguments are what stands inside."""

    def __init__(self, *args: Any) -> None:
        self.args = list(args)

    def copy(self) -> Any:
        return copy.deepcopy(self)

    def add_args(self, new_args: Iterable[Any]) -> Any:
        """A copy with more arguments."""
        new = self.copy()
        new.args += list(new_args)
        return new

    def __str__(self) -> str:
        return f"{_snake(type(self).__name__)} {{\n{_joined(self.args)}\n}}\n"


class Macro(POVRayElement):
    """A call of a macro: its name, then its arguments."""

    def __str__(self) -> str:
        return f"{self.args[0]}({', '.join(format_if_necessary(a) for a in self.args[1:])})\n"


def _snake(name: str) -> str:
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


def element(name: str) -> type[POVRayElement]:
    """The class for a block, by SDL's name (`sky_sphere`) or the class's (`SkySphere`)."""
    camel = "".join(part[:1].upper() + part[1:] for part in name.split("_"))
    return type(camel, (POVRayElement,), {"__doc__": f"`{_snake(camel)} {{ ... }}`", "__module__": __name__})


for _block in _BLOCKS.split():
    _class = element(_block)
    setattr(sys.modules[__name__], _class.__name__, _class)


class Scene:
    """A camera and what it sees.

    objects and atmospheric (Fog, Media ...) are elements; included: names of include files; defaults: what stands in #default;
    declares: `NAME = value`; global_settings: what stands in there.
    """

    def __init__(
        self,
        camera: POVRayElement,
        objects: Iterable[Any] = (),
        atmospheric: Iterable[Any] = (),
        included: Iterable[str] = (),
        defaults: Iterable[Any] = (),
        declares: Iterable[Any] = (),
        global_settings: Iterable[Any] = (),
    ) -> None:
        self.camera = camera
        self.objects = list(objects)
        self.atmospheric = list(atmospheric)
        self.included = list(included)
        self.defaults = list(defaults)
        self.declares = list(declares)
        self.global_settings = list(global_settings)

    def __str__(self) -> str:
        settings = [f"global_settings {{\n{_joined(self.global_settings)}\n}}"] if self.global_settings else []
        return "\n".join(
            [f'#include "{file}"' for file in self.included]
            + [f"#default {{ {format_if_necessary(e)} }}" for e in self.defaults]
            + [f"#declare {format_if_necessary(e)};" for e in self.declares]
            + settings
            + [format_if_necessary(e) for e in [*self.objects, self.camera, *self.atmospheric]]
        ) + "\n"

    def copy(self) -> Scene:
        return copy.deepcopy(self)

    def set_camera(self, new_camera: POVRayElement) -> Scene:
        """A copy with another camera."""
        new = self.copy()
        new.camera = new_camera
        return new

    def add_objects(self, objs: Iterable[Any]) -> Scene:
        """A copy with more objects."""
        new = self.copy()
        new.objects += list(objs)
        return new

    def render(
        self,
        outfile: str | None = None,
        height: int | None = None,
        width: int | None = None,
        quality: int | None = None,
        antialiasing: float | None = None,
        remove_temp: bool = True,
        auto_camera_angle: bool = True,
        show_window: bool = False,
        tempfile: str | None = None,
        includedirs: Iterable[str] | None = None,
        output_alpha: bool = False,
    ) -> Any:
        """See render_povstring(). auto_camera_angle: the camera gets the proportions of the picture."""
        scene = self
        if auto_camera_angle and width is not None and height is not None:
            scene = self.set_camera(self.camera.add_args(["right", [width / height, 0, 0]]))
        return render_povstring(str(scene), outfile, height, width, quality, antialiasing, remove_temp, show_window, tempfile,
                                includedirs, output_alpha)  # fmt: skip


def render_povstring(
    string: str,
    outfile: str | None = None,
    height: int | None = None,
    width: int | None = None,
    quality: int | None = None,
    antialiasing: float | None = None,
    remove_temp: bool = True,
    show_window: bool = False,
    tempfile: str | None = None,
    includedirs: Iterable[str] | None = None,
    output_alpha: bool = False,
) -> Any:
    """Renders text. Into a file, if outfile names one; "ipython": a picture that notebooks show; None: an array of uint8,
    (height, width, 3), or 4 with output_alpha. No file lies between; unless remove_temp, the text is kept as tempfile
    (__temp__.pov). show_window does nothing. Raises OSError with what is wrong.
    """
    name = tempfile or "__temp__.pov"
    if not remove_temp:
        with open(name, "w", encoding="utf-8") as file:
            file.write(string)
    if width is None:
        width = 320 if height is None else height * 4 // 3
    if height is None:
        height = width * 3 // 4
    try:
        picture = verisim.render(
            string.encode(),
            width,
            height,
            antialias=False if antialiasing is None else antialiasing,
            quality=9 if quality is None else quality,
            alpha=output_alpha,
            include_path=includedirs or (),
            name=os.path.basename(name),
        )
    except verisim.Error as error:
        raise OSError(f"POVRay rendering failed with the following error: {error}") from error
    if outfile is None:
        import numpy

        return numpy.array(picture)
    if outfile == "ipython":
        return picture
    picture.save(outfile)
    return None


__all__ = ["Macro", "POVRayElement", "Scene", "element", "format_if_necessary", "render_povstring", "vectorize"]
__all__ += [element(block).__name__ for block in _BLOCKS.split()]
