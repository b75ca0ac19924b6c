import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { exportReportSchema } from '../../schema/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const MAPS = fileURLToPath(new URL('../schema/fixtures/tiled', import.meta.url));

const sayable = (name: string) => fallThrough({ name, recoil: true, astronaut: { x: 300, y: 300 } });
const files = makeFiles({
  'levels/level-01.level.json': sayable('One'),
  'levels/level-03.level.json': sayable('Three'),
  'other/windy.level.json': fallThrough({ recoil: true, winds: [{ x: 1, y: 2, radius: 30 }], rules: { pull: 50 } }),
  'other/broken.level.json': '{',
  'two/a/same.level.json': sayable('A'),
  'two/b/same.level.json': sayable('B'),
});
const cwd = files.directory;
afterAll(files.remove);
const run = (...args: string[]) => gq(['export', ...args], { cwd });
const read = (name: string): string => readFileSync(join(cwd, name), 'utf8');

describe('gq export --to gravityquest', () => {
  it('writes all levels in order to standard output, and warns of what is lost on the other stream', async () => {
    const { code, stdout, stderr } = await run('levels', '--to', 'gravityquest');
    expect(code).toBe(0);
    const levels = JSON.parse(stdout);
    expect(levels).toHaveLength(2);
    expect(levels[0]).toMatchObject({ player: { x: 300, y: 300, key: 'player' }, maxDistance: 250 });
    expect(stderr).toMatch(
      /^warning: levels\/level-01\.level\.json, levels\/level-03\.level\.json: a level object has no place for its name, its run\n$/,
    );
  });

  it('writes a module that Node loads, and that gq import turns into the same levels again', async () => {
    const made = await run('levels', '--to', 'gravityquest', '--by-number', '-o', 'out/Levels.cjs');
    expect(made).toMatchObject({ code: 0, stdout: 'written out/Levels.cjs: 2 levels\n' });
    const loaded = execFileSync(process.execPath, ['-p', "JSON.stringify(require('./out/Levels.cjs'))"], {
      cwd,
      encoding: 'utf8',
    });
    expect(JSON.parse(loaded).map((level: object) => Object.keys(level).length > 0)).toEqual([false, true, false, true]);
    const back = await gq(['import', 'out/Levels.cjs', '--out', 'back'], { cwd });
    expect(back).toMatchObject({ code: 0, stderr: '' });
    expect(readdirSync(join(cwd, 'back')).sort()).toEqual(['level-01.level.json', 'level-03.level.json']);
    const again = await run('back', '--to', 'gravityquest', '--by-number', '-o', 'out/Levels2.cjs');
    expect(again.code).toBe(0);
    const withoutTitles = (text: string) => text.replace(/\/\/.*/g, '');
    expect(withoutTitles(read('out/Levels2.cjs'))).toBe(withoutTitles(read('out/Levels.cjs')));
  });

  it('refuses everything that the original game does not have, with places, and writes nothing', async () => {
    const refused = await run('levels', 'other/windy.level.json', '--to', 'gravityquest', '-o', 'never.json');
    expect(refused).toMatchObject({ code: 1, stdout: '' });
    expect(refused.stderr).toMatch(/^other\/windy\.level\.json:\d+:\d+: error not-in-original: the rule pull: expected 39/m);
    expect(refused.stderr).toMatch(/^other\/windy\.level\.json:\d+:\d+: error not-in-original: wind 1: /m);
    expect(refused.stderr).toMatch(/nothing was written.*--drop leaves them out\n$/);
    expect(existsSync(join(cwd, 'never.json'))).toBe(false);

    const dropped = await run('other/windy.level.json', '--to', 'gravityquest', '--drop', '--module');
    expect(dropped.code).toBe(0);
    expect(dropped.stdout).toMatch(/^'use strict';\n\nmodule\.exports = \[\n {2}\/\/ Level 0: /);
    expect(dropped.stderr).toContain('left out: wind 1: the original game has no winds');
  });

  it('reports invalid levels like any other command', async () => {
    const { code, stdout, stderr } = await run('other', '--to', 'gravityquest');
    expect({ code, stdout }).toEqual({ code: 1, stdout: '' });
    expect(stderr).toMatch(/^other\/broken\.level\.json:1:2: error truncated-json/);
  });

  it('overwrites no other file unasked', async () => {
    writeFileSync(join(cwd, 'mine.json'), 'mine');
    const refused = await run('levels', '--to', 'gravityquest', '-o', 'mine.json');
    expect(refused).toMatchObject({ code: 2, stdout: '' });
    expect(refused.stderr).toContain('mine.json');
    expect(read('mine.json')).toBe('mine');
    const json = ['levels', '--to', 'gravityquest', '-o', 'mine.json', '--format', 'json'];
    const forced = exportReportSchema.parse(JSON.parse((await run(...json, '--force')).stdout));
    expect(forced).toMatchObject({ version: 1, files: [{ file: 'mine.json', status: 'overwritten' }] });
    expect(forced.warnings).toHaveLength(2);
    expect(JSON.parse((await run(...json)).stdout).files[0].status).toBe('unchanged');
  });
});

describe('gq export --to tiled', () => {
  it('writes a map for each level, and gq import makes the same level of each', async () => {
    const made = await run('levels', '--to', 'tiled', '--out', 'maps');
    expect(made).toMatchObject({
      code: 0,
      stdout: 'written maps/level-01.tmj: 1 level\nwritten maps/level-03.tmj: 1 level\n',
      stderr: '',
    });
    expect(await run('levels/level-01.level.json', '--to', 'tiled', '-o', 'maps/level-01.tmx')).toMatchObject({ code: 0 });
    expect((await run('levels/level-01.level.json', '--to', 'tiled')).stdout).toBe(read('maps/level-01.tmj'));
    for (const map of ['maps/level-01.tmj', 'maps/level-01.tmx']) {
      const back = await gq(['import', map, '--out', 'from-maps', '--force'], { cwd });
      expect(back).toMatchObject({ code: 0, stderr: '' });
      const again = await gq(['check', 'from-maps', '--format', 'json'], { cwd });
      const first = await gq(['check', 'levels/level-01.level.json', '--format', 'json'], { cwd });
      const hash = (json: string) => JSON.parse(json).levels.map((level: { run: { hash: string } | null }) => level.run?.hash);
      expect(hash(again.stdout)).toEqual(hash(first.stdout));
    }
  });

  it('imports a map that a person drew, named after its file, and says what it ignored', async () => {
    const made = await gq(['import', join(MAPS, 'drawn.tmj'), '--out', 'drawn'], { cwd });
    expect(made).toMatchObject({ code: 0, stderr: '' });
    expect(made.stdout).toMatch(/^written drawn\/drawn\.level\.json\nnote: ignored the layer "Background"/);
    const refused = await gq(['import', join(MAPS, 'mistakes.tmx'), '--out', 'never'], { cwd });
    expect(refused.code).toBe(1);
    expect(refused.stderr).toMatch(/mistakes\.tmx:13:3: error unknown-class: object 3 "rock": /);
    expect(existsSync(join(cwd, 'never'))).toBe(false);
  });
});

describe('options that say nothing together', () => {
  it.each([
    ['levels --to tiled', 'expected one level, since a map holds one, found 2 levels'],
    ['levels --to tiled --module', '--module: expected --to gravityquest'],
    ['levels --to tiled --drop', '--drop: expected --to gravityquest'],
    ['levels --to gravityquest --out x', '--out x: expected --to tiled'],
    ['levels --to gravityquest -o x.tmj', 'expected a name that ends in .json, .js, .cjs'],
    ['levels --to gravityquest -o x.json --module', 'expected a name that ends in .js or .cjs'],
    ['levels --to gravityquest --format json', 'expected -o FILE beside it'],
    ['two --to gravityquest --by-number', 'two/a/same.level.json: expected a number'],
    ['two --to tiled --out maps2', 'found two/a/same.level.json and two/b/same.level.json'],
    ['levels', "required option '--to <format>' not specified"],
    ['nothing --to tiled', 'nothing: no such file or directory'],
  ])('gq export %s', async (args, message) => {
    const { code, stdout, stderr } = await run(...args.split(' '));
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });

  it('--recoil beside a map', async () => {
    const { code, stderr } = await gq(['import', join(MAPS, 'drawn.tmj'), '--out', 'never', '--recoil', 'off'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toContain('found a Tiled map');
  });
});
