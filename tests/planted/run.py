#!/usr/bin/env python3
"""Plants faults in scenes and counts how many the comparison finds, and of how many it names the cause first.

    run.py VERISIM                   200 faults in 40 scenes, three strengths
    run.py VERISIM --faults 24       a sample
    run.py VERISIM --kind 'light*'   some kinds; --scene, --strength, --seed choose, too
    run.py VERISIM --false-alarms    no faults: the scenes as they are

Both sides are the program itself; one reads a changed scene, or changes its picture (faulty). A fault that changes no
pixel by more than a code value at most at three places is none. Exit status 1 when less is found or named than --found and
--named say."""
import argparse
import collections
import concurrent.futures
import fnmatch
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import pictures  # noqa: E402
import scenes  # noqa: E402

SCENES = HERE.parent.parent / 'scenes'
# Forty scenes, every family of features.
CHOSEN = """shapes/torus/plain shapes/torus/difference shapes/box/plain shapes/csg/* shapes/prism/* shapes/lathe/* shapes/blob/* shapes/sphere/*
 shapes/cone/* shapes/superellipsoid/* shapes/mesh/* shapes/height_field/* shapes/isosurface/* shapes/sor/*
 light/finish/phong light/finish/specular light/finish/reflection light/finish/ambient light/finish/metallic light/finish/layered light/finish/diffuse
 light/lights/* light/shadows/* light/interior/* light/atmosphere/* light/area/*
 textures/pigments/* textures/normals/* textures/maps/* textures/warps/* textures/crackle/* textures/generators/*
 camera/normal/* global/media_absorption global/media_emission global/radiosity_one_bounce global/photons_glass
 lecture/glass_ball lecture/three_levels lecture/shadow""".split()


def chosen():
    """One scene of each pattern, the same ones always; some patterns give two."""
    out = []
    for pattern in CHOSEN:
        found = sorted(SCENES.glob(pattern + '.pov')) if pattern.endswith('*') else [SCENES / (pattern + '.pov')]
        step = max(1, len(found) // 2)
        out += [p for p in found[step - 1::step][:1] if p.exists()]
    return out[:40]


def planned(count, seed, kinds, strengths, only):
    """Faults in turn: kinds, scenes and strengths are spread evenly."""
    generator = random.Random(seed)
    texts = {p: p.read_text(encoding='latin-1') for p in chosen() if fnmatch.fnmatch(str(p), f'*{only}*')}
    names = [k for k in [*scenes.SCENES, *pictures.PICTURES] if fnmatch.fnmatch(k, kinds)]
    queues = {}
    for name in names:
        options = []
        for path, text in texts.items():
            for s in strengths:
                if name in pictures.PICTURES:
                    _, values, expected = pictures.PICTURES[name]
                    if s < len(values):
                        options.append((path, s, {'picture': [name, values[s]]}, expected))
                    continue
                made = scenes.SCENES[name](text, s, random.Random(f'{path.name}{name}{seed}'))
                if made and made[0] and made[0] != text:
                    options.append((path, s, {'scene': made[0]}, made[1]))
        generator.shuffle(options)
        queues[name] = options
    out = []
    while any(queues.values()):
        for name in names:
            if queues[name]:
                out.append((name, *queues[name].pop()))
    return out


class Planter:
    def __init__(self, program, folder, size):
        self.program, self.folder, self.size = str(pathlib.Path(program).resolve()), pathlib.Path(folder), size

    def run(self, path, fault, number):
        """The scene's line of the report, with this fault."""
        story, report = self.folder / f'{number}.fault', self.folder / f'{number}.json'
        story.write_text(json.dumps({'program': self.program, **fault}))
        judged = self.folder / f'{number}.sh'
        judged.write_text(f'#!/bin/sh\nVERISIM_FAULT={story} exec {sys.executable} -B {HERE / "faulty"} "$@"\n')
        judged.chmod(0o755)
        w, h = self.size
        command = [self.program, 'compare', str(path), f'+W{w}', f'+H{h}', '-A', '+FN16', '--oracle', self.program, '--oracle-cache',
                   str(self.folder / 'cache'), '--native', str(judged), '--threads', '1', '--quiet', '--json', str(report)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=600)
        if not report.exists():
            raise RuntimeError(done.stderr + done.stdout)
        return json.loads(report.read_text())['scenes'][0]


def visible(scene):
    m = scene['metrics']
    return m is None or m['max_abs'] > 1 and m['rmse'] > 0.02 or abs(m['bias']) > 0.1


def first_name(scene):
    return next((f"{s['what']}: {s['detail']}" for s in scene['suspects']), 'nothing')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('--faults', type=int, default=200)
    parser.add_argument('--kind', default='*')
    parser.add_argument('--scene', default='')
    parser.add_argument('--strength', type=int, choices=(0, 1, 2))
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--size', default='160x120')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('--found', type=float, default=0, help='least part that must be found')
    parser.add_argument('--named', type=float, default=0, help='least part that must be named first')
    parser.add_argument('--false-alarms', action='store_true')
    parser.add_argument('--verbose', action='store_true', help='all suspects of what is named wrongly')
    options = parser.parse_args()
    strengths = (0, 1, 2) if options.strength is None else (options.strength,)
    if options.false_alarms:
        plan = [('nothing', p, 0, {}, '') for p in chosen()]
    else:
        plan = planned(options.faults, options.seed, options.kind, strengths, options.scene)
    counts = collections.Counter()
    by_kind = collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory(prefix='verisim-planted-') as folder, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        planter = Planter(options.program, folder, tuple(map(int, options.size.split('x'))))
        waiting = iter(enumerate(plan))
        running = {}

        def start():
            for number, (name, path, s, fault, expected) in waiting:
                running[pool.submit(planter.run, path, fault, number)] = (name, path, s, expected)
                return
        for _ in range(options.jobs):
            start()
        while running:
            done = next(concurrent.futures.as_completed(running))
            name, path, s, expected = running.pop(done)
            scene = done.result()
            where = f'{path.relative_to(SCENES)} {name}, strength {s + 1}'
            if scene['status'] in ('error', 'unsupported', 'oracle_failed'):
                counts['not rendered'] += 1
            elif options.false_alarms:
                counts['tried'] += 1
                counts['false alarms'] += scene['status'] == 'differ'
                if scene['status'] == 'differ':
                    print(f'FALSE ALARM {where}: {scene["reason"]}; {first_name(scene)}')
            elif not visible(scene):
                counts['no change'] += 1
            else:
                counts['tried'] += 1
                found = scene['status'] == 'differ'
                rightly = found and bool(re.search(expected, first_name(scene)))
                counts['found'] += found
                counts['named'] += rightly
                by_kind[name].update(tried=1, found=found, named=rightly)
                if not rightly:
                    print(f'{"NAMED" if found else "MISSED"} {where}: {first_name(scene)} (wanted {expected}; {scene["reason"]})', flush=True)
                    if options.verbose:
                        for v in scene['suspects'][:6]:
                            print(f"      {v.get('sure', 0):.2f} {v['explained']:.2f} {v.get('precision', 0):.2f} {v['what']}: {v['detail']}")
            if counts['tried'] < options.faults:
                start()
    if options.false_alarms:
        print(dict(counts))
        return 1 if counts['false alarms'] else 0
    for name, c in sorted(by_kind.items()):
        print(f'{name:24} tried {c["tried"]:3}  found {c["found"]:3}  named {c["named"]:3}')
    tried = max(1, counts['tried'])
    print(f'{counts["tried"]} faults: {100 * counts["found"] / tried:.1f} % found, {100 * counts["named"] / tried:.1f} % named first; '
          f'{counts["no change"]} changed nothing that shows, {counts["not rendered"]} could not be rendered')
    return 0 if counts['found'] >= options.found * tried and counts['named'] >= options.named * tried else 1


if __name__ == '__main__':
    sys.exit(main())
