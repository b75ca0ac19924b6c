import { chmodSync, existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { chooseReports } from '../../../cli/reporters/destinations.ts';
import { REPORTER_NAMES } from '../../../cli/reporters/reporter.ts';
import { fallThrough, gq, gqProcess, makeFiles } from '../gq.ts';

const files = makeFiles({
  'levels/a.level.json': fallThrough(),
  'levels/b.level.json': fallThrough({ runs: [] }),
  'a-file': '',
});
afterAll(() => files.remove());
const cwd = files.directory;
const at = (name: string): string => join(cwd, name);

describe('the reports that are asked for', () => {
  it('are one for stdout and any number for files', () => {
    const name = fc.constantFrom(...REPORTER_NAMES);
    const file = fc.string({ minLength: 1 });
    fc.assert(
      fc.property(fc.array(fc.tuple(name, file)), fc.option(name), fc.option(name), (forFiles, plain, format) => {
        const reporter = [...forFiles.map(([n, f]) => `${n}=${f}`), ...(plain === null ? [] : [plain])];
        const ask = () => chooseReports({ reporter, ...(format === null ? {} : { format }) });
        if (plain !== null && format !== null) {
          expect(ask).toThrow('only one report can go to stdout');
          return;
        }
        const expected = [...forFiles.map(([n, f]) => ({ name: n, file: f })), { name: plain ?? format ?? 'pretty', file: null }];
        expect(ask()).toEqual(expected);
      }),
    );
  });

  it('come from the configuration where no option says otherwise', () => {
    const configured = ['github', 'json=out.json'];
    const json = { name: 'json', file: 'out.json' };
    expect(chooseReports({ configured })).toEqual([json, { name: 'github', file: null }]);
    expect(chooseReports({ configured, format: 'json' })).toEqual([json, { name: 'json', file: null }]);
    expect(chooseReports({ configured, reporter: ['pretty'] })).toEqual([{ name: 'pretty', file: null }]);
    expect(() => chooseReports({ configured: ['jsno'] })).toThrow(
      'reporters: "jsno" in the configuration: there is no reporter "jsno" (did you mean json?); expected one of',
    );
  });
});

describe('gq check --reporter', () => {
  it('writes files, with their folders, and prints the one for stdout', async () => {
    const ended = await gq(['check', '--reporter', 'json=out/deep/r.json', '--reporter', 'github=out/g.txt'], { cwd });
    expect(ended).toMatchObject({ code: 1, stderr: '' });
    expect(ended.stdout).toBe((await gq(['check'], { cwd })).stdout);
    expect(JSON.parse(readFileSync(at('out/deep/r.json'), 'utf8'))).toMatchObject({ version: 1, summary: { unproven: 1 } });
    expect(readFileSync(at('out/g.txt'), 'utf8')).toBe((await gq(['check', '--format', 'github'], { cwd })).stdout);
    const again = await gq(['check', 'levels/a.level.json', '--reporter', 'json=out/deep/r.json', '--reporter', 'github'], {
      cwd,
    });
    expect(again).toMatchObject({ code: 0, stdout: '1 level: 1 completable\n' });
    expect(JSON.parse(readFileSync(at('out/deep/r.json'), 'utf8')).levels).toHaveLength(1);
  });

  mkdirSync(at('folder'));
  writeFileSync(at('read-only.json'), '');
  chmodSync(at('read-only.json'), 0o444);
  symlinkSync('same.json', at('link.json'));
  writeFileSync(at('same.json'), 'old');
  it.each([
    ['the lock', 'conf/agreed.json'],
    ['the configuration', 'conf/strict.json'],
  ])('never replaces %s', async (what, file) => {
    mkdirSync(at('conf'), { recursive: true });
    writeFileSync(at('conf/strict.json'), '{ "lock": "agreed.json", "levels": "../levels" }');
    writeFileSync(at('conf/agreed.json'), '{ "version": 1, "levels": {} }');
    const ended = await gq(['check', '--config', 'conf/strict.json', '--reporter', `json=${file}`], { cwd });
    expect(ended).toMatchObject({ code: 2, stdout: '' });
    expect(ended.stderr).toContain(`the report would replace ${what}; give it another file`);
  });

  it.each([
    ['two for stdout', 'json github', 'only one report can go to stdout, found 2: json, github; give the others a file'],
    ['an unknown name', 'jnuit=x.xml', '--reporter jnuit=x.xml: there is no reporter "jnuit"'],
    ['no file', 'json=', '--reporter json=: expected a file after the ='],
    ['a folder', 'json=folder', "folder can't be written: it is a folder"],
    ['the name of a folder', 'json=new/', "new/ can't be written: it names a folder"],
    ['a file as a folder', 'json=a-file/x/y.json', "a-file/x/y.json can't be written: "],
    ['a read-only file', 'json=read-only.json', "read-only.json can't be written: it is read-only (mode 444)"],
    ['the same file twice', 'json=new/x github=./new/../new/x', '--reporter json=new/x writes the same file'],
    ['the same file by a link', 'json=same.json github=link.json', '--reporter json=same.json writes the same file'],
    ['a level', 'json=levels/a.level.json', 'the report would replace a level that is checked'],
  ])('refuses %s before the work', async (_, reporters, message) => {
    const args = reporters.split(' ').flatMap((reporter) => ['--reporter', reporter]);
    const ended = await gq(['check', ...args], { cwd });
    expect(ended).toMatchObject({ code: 2, stdout: '' });
    expect(ended.stderr).toContain(message);
    expect(readFileSync(at('same.json'), 'utf8')).toBe('old');
  });

  it.runIf(existsSync('/dev/full'))(
    'ends with 2 if a file can no longer be written after the work, and reports all the same',
    async () => {
      const late = await gqProcess(
        ['check', 'levels/a.level.json', '--reporter', 'json=/dev/full', '--reporter', 'github=late/g.txt'],
        { cwd },
      );
      expect(late).toMatchObject({ code: 2, stderr: "error: /dev/full: can't be written: no space left on the device\n" });
      expect(late.stdout).toContain('1 completable');
      expect(readFileSync(at('late/g.txt'), 'utf8')).toBe('1 level: 1 completable\n');
    },
  );
});
