import { symlinkSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { openedPlace } from '../../cli/serve/opened-place.ts';
import { levelText, makeFolder } from './running.ts';

const made = makeFolder({
  'levels/a.level.json': levelText('a'),
  'levels/world/b.level.json': levelText('b'),
  'levels/.hidden/h.level.json': levelText('h'),
  'drafts/c.level.json': levelText('c'),
  'world/slingshot.level.json': levelText('s'),
  'd.level.json': levelText('d'),
  'two:12.level.json': levelText('two'),
  'odd/e.level.json:7': levelText('e'),
  'other.json': levelText('other'),
});
const before = process.cwd();
beforeAll(() => process.chdir(made.folder));
afterAll(() => {
  process.chdir(before);
  made.remove();
});

const at = (level: string, tick: number | null = null, run: string | null = null) => ({
  level: `${level}.level.json`,
  run,
  tick,
});

describe('the place that gq edit opens', () => {
  it.each([
    [undefined, undefined, 'levels', null],
    ['drafts', undefined, 'drafts', null],
    // a file in the usual folder, below it, and outside
    [undefined, 'levels/a.level.json', 'levels', at('a')],
    [undefined, 'levels/a.level.json:412', 'levels', at('a', 412)],
    [undefined, './levels/world/b.level.json:0', 'levels', at('world/b', 0)],
    [undefined, 'drafts/c.level.json:3', 'drafts', at('c', 3)],
    [undefined, 'd.level.json', '.', at('d')],
    ['levels/world', 'levels/world/b.level.json:5', 'levels/world', at('b', 5)],
    ['.', 'levels/world/b.level.json:5', '.', at('levels/world/b', 5)],
    // as it is called in the folder
    ['levels', 'world/b.level.json:5', 'levels', at('world/b', 5)],
    [undefined, 'levels/.hidden/h.level.json', 'levels/.hidden', at('h')],
    [undefined, 'two:12.level.json', '.', at('two:12')],
    [undefined, 'two:12.level.json:12', '.', at('two:12', 12)],
    // the folder after the option
    [undefined, 'drafts', 'drafts', null],
  ])('gq edit %s --open %s', (dir, wanted, folder, place) => {
    expect(openedPlace(dir, wanted, undefined)).toEqual({ folder, place });
  });

  it('has the run that --run names', () => {
    expect(openedPlace(undefined, 'd.level.json:9', 'all minerals').place).toEqual(at('d', 9, 'all minerals'));
  });

  it.runIf(process.platform !== 'win32')('is found through links of folders', () => {
    symlinkSync(join(made.folder, 'levels'), join(made.folder, 'link'));
    expect(openedPlace(undefined, 'link/a.level.json:1', undefined)).toEqual({ folder: 'levels', place: at('a', 1) });
  });

  it.each([
    [undefined, undefined, 'x', /^--run names the run that --open shows: give --open FILE as well$/],
    [
      undefined,
      'world/slingshott.level.json:3',
      undefined,
      /^--open world\/slingshott\.level\.json:3: no such file or directory \(did you mean slingshot\.level\.json\?\); expected FILE or FILE:TICK/,
    ],
    [undefined, 'nowhere/x.level.json', undefined, /^--open nowhere\/x\.level\.json: no such file or directory; expected/],
    [undefined, '', undefined, /^--open "": .*expected FILE/],
    [undefined, ':3', undefined, /^--open :3: .*expected FILE/],
    [undefined, 'd.level.json:', undefined, /^--open d\.level\.json:: expected a tick after the colon, .*found ""$/],
    [undefined, 'd.level.json:x', undefined, /found "x"$/],
    [undefined, 'd.level.json:-3', undefined, /found "-3"$/],
    [undefined, 'd.level.json:1.5', undefined, /found "1\.5"$/],
    [undefined, 'd.level.json:12345678901', undefined, /found "12345678901"$/],
    [undefined, 'drafts:3', undefined, /^--open drafts:3: is a folder; expected FILE/],
    ['drafts', 'levels', undefined, /^--open levels: is a folder; expected FILE/],
    [undefined, 'drafts', 'x', /^--open drafts: is a folder; expected FILE/],
    [
      undefined,
      'other.json:3',
      undefined,
      /^--open other\.json: the editor opens only files whose names end in \.level\.json; rename it$/,
    ],
    [
      'drafts',
      'd.level.json:3',
      undefined,
      /^--open d\.level\.json: the folder drafts does not show this file: .*try gq edit \. --open d\.level\.json:3$/,
    ],
    ['levels', 'levels/.hidden/h.level.json', undefined, /not in a hidden folder/],
    ['nowhere', 'd.level.json', undefined, /^--open d\.level\.json: the folder nowhere does not show this file/],
  ])('gq edit %s --open %s --run %s is refused', (dir, wanted, run, message) => {
    expect(() => openedPlace(dir, wanted, run)).toThrow(message);
  });
});
