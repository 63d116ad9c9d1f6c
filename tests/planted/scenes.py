"""Faults of scenes: what a renderer would have understood wrongly, as a change of the text that it is given.

A fault is a function of (text, strength 0..2, random.Random) that returns the changed text and what must be named first, as a
pattern of "what: detail", or None where the scene has nothing to change."""
import re

from sdl import about_itself, appended, blanked, blocks, objects, replaced_color, replaced_number, vector, without

SIMPLE = [k for k in 'sphere box cylinder cone torus disc prism lathe sor superellipsoid blob union merge difference intersection '
          'object text mesh mesh2 polygon height_field julia_fractal sphere_sweep ovus quadric isosurface'.split()]


def an_object(text, generator, words=SIMPLE):
    found = [b for b in objects(text) if b.word in words]
    return generator.choice(found) if found else None


def named(block, what=''):
    return rf'{what}.*(:|line ){block.line}[,)]'


def missing(text, s, generator):
    block = an_object(text, generator)
    return block and (without(text, block), named(block, 'object missing'))


def added(text, s, generator):
    block = an_object(text, generator, ['sphere', 'box', 'torus'])
    camera = blocks(text, ['camera'])
    if not block or not camera:
        return None
    eye, at = vector(camera[0].body, 'location'), vector(camera[0].body, 'look_at')
    if not eye or len(eye) != 3:
        return None
    at = at if at and len(at) == 3 else [0, 0, 0]
    part = 0.6
    place = [e + part * (a - e) for e, a in zip(eye, at)]
    size = (0.03, 0.08, 0.2)[s] * sum((a - e) ** 2 for e, a in zip(eye, at)) ** 0.5 * part
    extra = 'sphere { <%s>, %.4g pigment { rgb <0.9, 0.3, 0.2> } }' % (', '.join('%.4g' % p for p in place), size * 0.5)
    return text[:block.start] + extra + ' ' + text[block.start:], named(block, 'object (added|too much)')


def moved(text, s, generator):
    block = an_object(text, generator)
    d = (0.02, 0.06, 0.3)[s]
    return block and (appended(text, block, f'translate <{d}, {d / 2}, 0>'), named(block, 'object moved'))


def scaled(text, s, generator):
    block, factor = an_object(text, generator), (1.02, 1.06, 1.25)[s]
    if not block:
        return None
    if block.word == 'sphere':
        changed = replaced_number(text, r'sphere\s*\{\s*(?:<[^<>]*>|[-\d.]+)\s*,', lambda v: v * factor, within=block)
    else:
        changed = about_itself(text, block, f'scale {factor}')
    return changed and (changed, named(block, 'object (scaled|moved)' if block.word == 'object' else 'object scaled'))


def turned(text, s, generator):
    block = an_object(text, generator, [w for w in SIMPLE if w not in ('sphere', 'blob')])
    changed = block and about_itself(text, block, f'rotate <0, {(2, 6, 25)[s]}, {(1, 3, 10)[s]}>')
    return changed and (changed, named(block, 'object (rotated|moved|scaled|shape)'))


def shape(text, s, generator):
    block = an_object(text, generator, ['prism', 'lathe', 'sor', 'torus', 'cylinder', 'cone', 'superellipsoid', 'box'])
    if not block:
        return None
    numbers = list(re.finditer(r'(?<![\w.])\d*\.\d+', blanked(block.body)))[:3]
    if not numbers:
        return None
    m = generator.choice(numbers)
    value = float(m[0]) * (1.03, 1.1, 1.3)[s]
    return text[:block.start + m.start()] + f'{value:.5g}' + text[block.start + m.end():], named(block)


def finish_number(word, factors, what):
    def fault(text, s, generator):
        for which in (0, 1):
            changed = replaced_number(text, r'\b' + word, lambda v: v * factors[s], which)
            if changed and changed != text:
                return changed, what
        return None
    return fault


def color(text, s, generator):
    block = an_object(text, generator)
    changed = block and replaced_color(text, block, lambda c: [c[0] * (0.97, 0.9, 0.5)[s], c[1], c[2]])
    return changed and (changed, named(block))


def darker(text, s, generator):
    block = an_object(text, generator)
    changed = block and replaced_color(text, block, lambda c: [v * (0.98, 0.92, 0.6)[s] for v in c])
    return changed and (changed, named(block))


def lights(text):
    return blocks(text, ['light_source'])


def light_missing(text, s, generator):
    found = lights(text)
    return (without(text, generator.choice(found)), 'light missing') if found else None


def light_dimmed(text, s, generator):
    found = lights(text)
    changed = found and replaced_color(text, generator.choice(found), lambda c: [v * (0.98, 0.9, 0.5)[s] for v in c])
    return (changed, 'light (strength|color)|brightness: the') if changed else None


def light_tinted(text, s, generator):
    found = lights(text)
    changed = found and replaced_color(text, generator.choice(found), lambda c: [c[0], c[1], c[2] * (0.97, 0.85, 0.4)[s]])
    return (changed, 'light color|color balance') if changed else None


def light_moved(text, s, generator):
    found = lights(text)
    if not found:
        return None
    d = (0.1, 0.4, 2)[s]
    return appended(text, generator.choice(found), f'translate <{d}, 0, {-d}>'), 'light moved'


def light_without_shadow(text, s, generator):
    found = lights(text)
    return (appended(text, generator.choice(found), 'shadowless'), 'shadow|light') if found else None


def object_without_shadow(text, s, generator):
    block = an_object(text, generator)
    return block and (appended(text, block, 'no_shadow'), 'shadow|light')


def camera(words, what):
    def fault(text, s, generator):
        found = blocks(text, ['camera'])
        changed = found and words(text, found[0], s)
        return (changed, what) if changed else None
    return fault


def zoomed(text, block, s):
    return replaced_number(text, r'\bangle', lambda v: v * (1.01, 1.04, 1.2)[s], within=block)


def camera_moved(text, block, s):
    eye = vector(block.body, 'location')
    if not eye or len(eye) != 3:
        return None
    d = (0.01, 0.04, 0.2)[s]
    m = re.search(r'\blocation\s*<[^<>]*>', blanked(text)[block.start:block.end])
    place = ', '.join(f'{v:.6g}' for v in (eye[0] + d, eye[1] + d / 2, eye[2]))
    return text[:block.start + m.start()] + f'location <{place}>' + text[block.start + m.end():]


def stretched(text, block, s):
    return None if 'right' in block.body else appended(text, block, f'right x * {4 / 3 * (1.01, 1.04, 1.15)[s]:.6g}')


def without_block(word, what):
    def fault(text, s, generator):
        found = [b for d in (0, 1, 2, 3) for b in blocks(text, [word], d)] or [
            b for outer in blocks(text, ['global_settings', *SIMPLE, 'interior']) for b in blocks(text, [word], 0, outer)]
        return (without(text, found[0]), what) if found else None
    return fault


def part_missing(text, s, generator):
    """One child of a CSG object is lost."""
    outer = an_object(text, generator, ['union', 'merge', 'difference', 'intersection'])
    inner = outer and blocks(text, SIMPLE, 0, outer)
    return (without(text, inner[-1]), named(outer) + '|' + named(inner[-1]) + '|' + named(inner[0])) if inner and len(inner) > 2 else None


def part_moved(text, s, generator):
    outer = an_object(text, generator, ['union', 'merge', 'difference', 'intersection'])
    inner = outer and blocks(text, SIMPLE, 0, outer)
    if not inner:
        return None
    d = (0.03, 0.08, 0.25)[s]
    return appended(text, inner[-1], f'translate <{d}, {d}, 0>'), '|'.join(named(b) for b in [outer, *inner])


def background(text, s, generator):
    found = blocks(text, ['background'])
    changed = found and replaced_color(text, found[0], lambda c: [min(1, c[0] + (0.01, 0.05, 0.3)[s]), c[1], c[2]])
    return (changed, 'background|sky') if changed else None


def global_setting(words, what):
    def fault(text, s, generator):
        found = blocks(text, ['global_settings'])
        return (appended(text, found[0], words[s]), what) if found else None
    return fault


def number(pattern, factors, what):
    def fault(text, s, generator):
        changed = replaced_number(text, pattern, lambda v: v * factors[s])
        return (changed, what) if changed and changed != text else None
    return fault


SCENES = {
    'object missing': missing, 'object added': added, 'object moved': moved, 'object scaled': scaled, 'object turned': turned, 'shape': shape,
    'color': color, 'darker': darker,
    'diffuse': finish_number('diffuse', (0.98, 0.92, 0.6), r'object .*:\d+\)|light|brightness'),
    'ambient': finish_number('ambient', (1.1, 1.4, 3), r'ambient|brightness: .*:\d+|offset: .*:\d+|contrast: .*:\d+|own light'),
    'highlight': finish_number('(?:phong|specular)', (0.9, 0.6, 0), 'highlight'),
    'highlight size': finish_number('(?:phong_size|roughness)', (1.1, 1.5, 4), 'highlight'),
    'reflection': finish_number('reflection', (0.95, 0.7, 0), 'reflection'),
    'refraction': finish_number('ior', (1.01, 1.05, 1.3), 'transparency|refract'),
    'pattern scale': number(r'(?:bozo|granite|marble|wood|agate|leopard|checker|crackle|onion|wrinkles)\b[^{}]*?\bscale', (1.01, 1.05, 1.3), 'texture|pattern|noise|normals'),
    'turbulence': number(r'\bturbulence', (1.02, 1.1, 1.5), 'texture|noise|pattern'),
    'normal depth': number(r'\bnormal\s*\{\s*\w+', (1.05, 1.3, 3), 'normal'),
    'light missing': light_missing, 'light dimmed': light_dimmed, 'light tinted': light_tinted, 'light moved': light_moved,
    'light without shadow': light_without_shadow, 'object without shadow': object_without_shadow,
    'spot radius': number(r'\b(?:falloff)', (1.03, 1.1, 1.4), 'light'), 'fade distance': number(r'\bfade_distance', (1.02, 1.1, 1.5), 'light|transparency'),
    'camera zoom': camera(zoomed, 'zoom'), 'camera moved': camera(camera_moved, 'shift|camera|zoom|rotation'), 'camera width': camera(stretched, 'stretched|zoom'),
    'fog distance': number(r'\bfog\s*\{[^{}]*?\bdistance', (1.02, 1.1, 1.6), 'fog'), 'no fog': without_block('fog', 'fog'),
    'media density': number(r'\bmedia\s*\{[^{}]*?\b(?:absorption|emission)', (1.05, 1.3, 2), 'media'), 'no media': without_block('media', 'media'),
    'no radiosity': without_block('radiosity', 'radiosity'), 'radiosity brightness': number(r'\bbrightness', (0.95, 0.8, 0.4), 'radiosity'),
    'no photons': without_block('photons', 'photons'),
    'background': background, 'part missing': part_missing, 'part moved': part_moved,
    'noise generator': global_setting(['noise_generator 1', 'noise_generator 2', 'noise_generator 1'], 'noise|texture|normal'),
    'trace level': global_setting(['max_trace_level 2', 'max_trace_level 1', 'max_trace_level 1'], 'reflection|transparency|refract'),
    'ambient light': global_setting(['ambient_light rgb 1.1', 'ambient_light rgb 0.7', 'ambient_light rgb 2'], 'ambient'),
}
