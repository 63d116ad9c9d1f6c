"""Blocks of SDL as faults need them: where they begin and end, and changes that keep the lines where they are."""
import re

OBJECTS = ("sphere box plane cone cylinder torus disc triangle polygon poly quadric cubic quartic superellipsoid ovus blob lathe "
           "sor prism sphere_sweep bicubic_patch height_field isosurface parametric julia_fractal text mesh mesh2 "
           "union merge difference intersection object").split()


def blanked(text):
    """The same text with comments and strings blanked out, so that braces and words can be counted."""
    return re.sub(r'//[^\n]*|/\*.*?\*/|"[^"\n]*"', lambda m: re.sub(r'[^\n]', ' ', m[0]), text, flags=re.S)


class Block:
    def __init__(self, text, word, start, end):
        self.word, self.start, self.end = word, start, end  # of the word; behind the closing brace
        self.line = text.count('\n', 0, start) + 1
        self.body = text[start:end]

    def __repr__(self):
        return f'{self.word}:{self.line}'


def blocks(text, words, depth=0, inside=None):
    """Blocks with one of the words, at a depth of braces; not those that are declared for later, nor loops and macros."""
    plain = blanked(text)
    begin, stop = (0, len(text)) if inside is None else (inside.body.index('{') + inside.start + 1, inside.end - 1)
    found, level, at = [], 0, begin
    for token in re.finditer(r'[{}]', plain[begin:stop]):
        position = begin + token.start()
        if token[0] == '{':
            if level == depth:
                at = position
            level += 1
        else:
            level -= 1
            if level != depth:
                continue
            before = plain[begin:at]
            word = re.search(r'(\w+)\s*$', before)
            if word and word[1] in words and not re.search(r'(#declare|#local)\s+\w+\s*(\[[^\]]*\])*\s*=\s*$', before[:word.start()]):
                found.append(Block(text, word[1], begin + word.start(), position + 1))
    return found


def objects(text):
    if re.search(r'#(while|for|macro|if|switch)', text):
        text = re.sub(r'#(macro|while|for|if|ifdef|ifndef|switch)\b.*?#end', lambda m: re.sub(r'[^\n]', ' ', m[0]), text, flags=re.S)
    return [b for b in blocks(text, OBJECTS)]


def without(text, block):
    """The block is gone, its lines stay."""
    return text[:block.start] + re.sub(r'[^\n]', ' ', block.body) + text[block.end:]


def appended(text, block, words):
    """Words at the end of a block."""
    return text[:block.end - 1] + ' ' + words + ' ' + text[block.end - 1:]


def about_itself(text, block, words):
    """Words before the last movement of a block: a turn or a scale about what was its middle before."""
    plain = blanked(text)
    places = [m.start() for m in re.finditer(r'\btranslate\b', plain[block.start:block.end])]
    level = lambda at: plain[block.start:at].count('{') - plain[block.start:at].count('}')
    places = [block.start + p for p in places if level(block.start + p) == 1]
    return text[:places[-1]] + words + ' ' + text[places[-1]:] if places else None


NUMBER = r'-?\d+\.?\d*(?:[eE][-+]?\d+)?|-?\.\d+'


def replaced_number(text, pattern, change, which=0, within=None):
    """The number behind a pattern, changed; None where there is none."""
    begin, end = (within.start, within.end) if within else (0, len(text))
    found = [m for m in re.finditer(pattern + r'\s+(' + NUMBER + r')(?![\w.]|\s*[*/+])', blanked(text)[begin:end])]
    if len(found) <= which:
        return None
    a, b = found[which].span(found[which].lastindex)
    value = change(float(text[begin + a:begin + b]))
    return text[:begin + a] + f'{value:.6g}' + text[begin + b:]


def replaced_color(text, block, change, word='rgb'):
    """The first colour of a block, changed; None where there is none that stands there as numbers."""
    plain = blanked(text)[block.start:block.end]
    found = re.search(r'\b' + word + r'\s*(?:<\s*([^<>]*)>|(' + NUMBER + r')(?![\w.]|\s*[*/+]))', plain)
    if not found:
        return None
    try:
        values = [float(v) for v in found[1].split(',')] if found[1] else [float(found[2])] * 3
    except ValueError:
        return None
    new = change(values[:3]) + values[3:]
    return text[:block.start + found.start()] + word + ' <' + ', '.join(f'{v:.6g}' for v in new) + '>' + text[block.start + found.end():]


def vector(text, word):
    """The literal vector behind a word."""
    found = re.search(r'\b' + word + r'\s*<([^<>]*)>', blanked(text))
    try:
        return [float(v) for v in found[1].split(',')] if found else None
    except ValueError:
        return None
