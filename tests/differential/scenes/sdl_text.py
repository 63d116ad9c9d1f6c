"""SDL text as tokens, and as a tree of statements: what the mutations and the reducer cut and move.

A statement is what begins at a keyword that may begin one (or at a directive) and lasts until the next such keyword of
the same block. Blocks in braces are trees inside of it. This is a reading for cutting, not a parser: what is cut wrongly
both programs refuse, and nothing is learnt from it.
"""
import re

TOKEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|#\s*[a-z]\w*|[A-Za-z_]\w*'
    r"|\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?|!=|<=|>=|\S",
    re.S,
)
NUMBER = re.compile(r"^(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")

STARTERS = set(
    """
    camera light_source background fog sky_sphere rainbow global_settings media radiosity photons material texture
    pigment normal finish interior interior_texture bounded_by clipped_by translate rotate scale matrix transform
    no_shadow no_image no_reflection no_radiosity inverse hollow double_illuminate sturm open uv_mapping
    uv_vectors vertex_vectors normal_vectors face_indices texture_list uv_indices normal_indices inside_vector
    sphere box cylinder cone torus plane disc triangle smooth_triangle polygon prism lathe sor blob mesh mesh2
    height_field bicubic_patch superellipsoid sphere_sweep isosurface parametric quadric quartic cubic poly polynomial
    julia_fractal text ovus object union merge intersection difference
    ambient diffuse specular phong phong_size roughness brilliance metallic reflection irid crand emission
    conserve_energy subsurface use_alpha
    color_map colour_map pigment_map normal_map texture_map slope_map density_map density warp turbulence octaves omega
    lambda frequency phase ramp_wave sine_wave triangle_wave scallop_wave cubic_wave poly_wave noise_generator
    bump_size accuracy quick_color map_type interpolate once filter transmit brick_size mortar
    ior caustics dispersion dispersion_samples fade_distance fade_power fade_color fade_colour
    location look_at direction right up sky angle aperture blur_samples focal_point confidence variance
    perspective orthographic fisheye ultra_wide_angle omnimax panoramic spherical cylindrical
    spotlight area_light parallel fill_light shadowless looks_like projected_through point_at radius falloff tightness
    jitter adaptive circular orient media_attenuation media_interaction
    scattering absorption intervals samples method ratio aa_level aa_threshold emission
    contained_by threshold max_gradient evaluate max_trace all_intersections smooth water_level hierarchy
    cutaway_textures split_union
    assumed_gamma ambient_light max_trace_level adc_bailout irid_wavelength number_of_waves charset mm_per_unit
    count error_bound gray_threshold low_error_factor minimum_reuse nearest_count normal pretrace_start pretrace_end
    recursion_limit brightness always_sample spacing autostop collect refraction target pass_through
""".split()
)
OPENING, CLOSING = {"{": "}", "(": ")", "[": "]"}, {"}", ")", "]"}


def tokens(text):
    """Tokens without comments and white space; a directive's `#` and its name are one."""
    return [re.sub(r"^#\s+", "#", t) for t in TOKEN.findall(text) if not t.startswith(("//", "/*"))]


class Block(list):
    """What stands between two brackets: a list of statements, each a list of tokens and Blocks."""

    def __init__(self, opening, statements=()):
        super().__init__(statements)
        self.opening = opening


def parse(text):
    """The whole text as a Block without brackets; None where the brackets do not match."""
    stack = [Block("", [[]])]
    previous = ""
    declaring = False  # after `#declare X`, until its value begins: `#declare T = texture {` is one statement
    for token in tokens(text):
        top = stack[-1]
        if token.startswith("#") or token in STARTERS and not declaring and top.opening in ("", "{"):
            if top[-1]:
                top.append([])
        if token in ("#declare", "#local", "#macro", "#default"):
            declaring = True
        elif declaring and (previous == "=" or token in "{;(" or previous == "#default"):
            declaring = False
        if token in OPENING:
            stack.append(Block(token, [[]]))
        elif token in CLOSING:
            if len(stack) == 1 or OPENING[top.opening] != token:
                return None
            stack.pop()
            stack[-1][-1].append(top)
        else:
            top[-1].append(token)
        previous = token
    return stack[0] if len(stack) == 1 else None


def _flat(block, out):
    for statement in block:
        if block.opening in ("", "{"):
            out.append("\n")
        for item in statement:
            if isinstance(item, Block):
                out.append(item.opening)
                _flat(item, out)
                out.append(OPENING[item.opening])
            else:
                out.append(item)


def render(block):
    """The text of a tree, a statement a line."""
    out = []
    _flat(block, out)
    text = " ".join(out)
    text = re.sub(r" ([,;)\]])", r"\1", re.sub(r"([(\[]) ", r"\1", text))
    text = re.sub(r"([<,(] ?)- (?=[\d.])", r"\1-", text).replace("< ", "<").replace(" >", ">")
    lines, depth = [], 0
    for line in text.split("\n"):
        line = line.strip()
        if line:
            lines.append("  " * max(0, depth - (line[0] == "}")) + line)
            depth += line.count("{") - line.count("}")
    return "\n".join(lines) + "\n"


def blocks(block):
    """All blocks that hold statements, outermost first."""
    yield block
    for statement in block:
        for item in statement:
            if isinstance(item, Block):
                yield from blocks(item)


def keywords(text):
    """Words of a text that are no names of its own, in order of first appearance."""
    own = set(re.findall(r"#\s*(?:declare|local|macro|for\s*\()\s*(\w+)", text))
    seen = {}
    for token in tokens(text):
        if re.match(r"#?[a-z_]\w*$", token) and token not in own:
            seen.setdefault(token)
    return list(seen)
