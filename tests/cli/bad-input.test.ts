import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { CODES } from '../../schema/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const good = fallThrough();
const asteroid = (radius: string): string => good.replace('"radius":16', `"radius":${radius}`);

const POINTER = `version https://git-lfs.github.com/spec/v1\noid sha256:${'0'.repeat(64)}\nsize 812\n`;
const MERGE = '\n<<<<<<< HEAD\n"range":200,\n=======\n"range":300,\n>>>>>>> other\n"asteroids":';

// content of the file, code of the problem, and its place; apart from that problem, each is a valid level
const INVALID: readonly [name: string, content: string | Uint8Array, code: string, place: string][] = [
  ['empty', '', 'empty-file', ':1:1'],
  [
    'not-utf8',
    Buffer.concat([Buffer.from(good.slice(0, 20)), Buffer.from([0xff, 0xfe]), Buffer.from(good.slice(20))]),
    'not-utf8',
    ':1:21',
  ],
  ['truncated', good.slice(0, -20), 'truncated-json', ':1:'],
  ['duplicate-key', good.replace('{"version":1', '{"version":1,\n"version":1'), 'duplicate-key', ':2:1'],
  ['proto', good.replace('{"version":1', '{"version":1,\n"__proto__":{"name":"x"}'), 'unknown-key', ':2:1'],
  ['infinite', good.replace('"x":170', '\n"x":1e999'), '', ':2:'],
  ['nan', good.replace('"x":170', '\n"x":NaN'), '', ':2:'],
  ['deep', '['.repeat(100_000) + ']'.repeat(100_000), 'too-deep', ':1:65'],
  ['huge', `{"version":1,"name":"${'x'.repeat(50_000_000)}"}`, 'file-too-large', ''],
  ['newer', good.replace('"version":1', '"version":99'), '', ':1:'],
  ['unknown-key', good.replace('"asteroids":', '\n"asteriods":'), 'unknown-key', ':2:1'],
  ['zero-radius', asteroid('\n0'), '', ':2:1'],
  ['negative-radius', asteroid('\n-16'), '', ':2:1'],
  ['two-astronauts', good.replace('"astronaut":{"x":0,"y":0}', '"astronaut":\n[{"x":0,"y":0},{"x":1,"y":0}]'), '', ':2:1'],
  ['two-astronaut-keys', good.replace('"astronaut":', '"astronaut":{"x":9,"y":9},\n"astronaut":'), 'duplicate-key', ':2:1'],
  ['hold-reversed', good.replace('[0,600]', '\n[600,0]'), '', ':2:'],
  ['hold-negative', good.replace('[0,600]', '\n[-5,600]'), '', ':2:'],
  ['hold-fraction', good.replace('[0,600]', '\n[0.5,600]'), '', ':2:'],
  ['git-lfs', POINTER, 'pointer-file', ':1:1'],
  ['merge', good.replace('"asteroids":', MERGE), 'merge-markers', ':2:1'],
  ['login', '<!DOCTYPE html><title>Sign in</title>', 'not-a-level', ''],
  ['not-json', 'version: 1\n', 'invalid-json', ':1:1'],
  ['a-list', '[]', '', ':1:1'],
];

const files = makeFiles({
  ...Object.fromEntries(INVALID.map(([name, content]) => [`invalid/${name}.level.json`, content])),
  'fine/good.level.json': good,
  'fine/overlapping.level.json': good.replace('[0,600]', '[0,300],[200,600]'),
  'fine/crowd.level.json': fallThrough({
    asteroids: [
      { x: 100, y: 0, radius: 16 },
      ...Array.from({ length: 99_999 }, (_, i) => ({ x: 1e5 + i * 40, y: 0, radius: 16 })),
    ],
  }),
  'bom/bom.level.json': `\ufeff${good}`,
  'merged/a.level.json': good,
  'merged/pack.json': `{ "version": 1,${MERGE.replace('"asteroids":', '"levels": ["a"] }')}`,
  'merged/gq.config.json': `{${MERGE.replace('"asteroids":', '"levels": "." }')}`,
  'merged/gq.lock.json': `{ "version": 1,${MERGE.replace('"asteroids":', '"levels": {} }')}`,
  'lfs/a.level.json': good,
  'lfs/pack.json': POINTER,
  'lfs/gq.config.json': POINTER,
  'lfs/gq.lock.json': POINTER,
  'merged.tmx': `<?xml version="1.0"?>${MERGE.replace(/"range":(\d+),/g, '<map width="$1"/>').replace('"asteroids":', '')}`,
  'lfs.tmx': POINTER,
  'lfs.gqr': POINTER,
  'nothing/readme.md': 'no level here',
  'a-file': 'not a directory',
  'originals.json': JSON.stringify([
    { player: { x: 0, y: 0 }, target: { x: 9, y: 9, radius: 18 }, asteroids: [], maxDistance: 250 },
  ]),
});
const cwd = files.directory;
afterAll(files.remove);

describe('an invalid file', () => {
  it('is reported with its place, a code that explain knows, and exit code 1', async () => {
    const { code, signal, stdout, stderr } = await gq(['check', 'invalid', '--format', 'json'], { cwd });
    expect({ code, signal, stderr }).toEqual({ code: 1, signal: null, stderr: '' });
    const report = JSON.parse(stdout);
    expect(report.summary.invalid).toBe(INVALID.length);
    const known = CODES.map((c) => c.code);
    for (const [name, , expectedCode] of INVALID) {
      const level = report.levels.find((l: { file: string }) => l.file === `invalid/${name}.level.json`);
      expect(level, name).toMatchObject({ name, verdict: 'invalid', run: null });
      expect(level.problems.length, name).toBeGreaterThan(0);
      if (expectedCode !== '') expect(level.problems[0].code, name).toBe(expectedCode);
      for (const problem of level.problems) expect(known, name).toContain(problem.code);
    }
  });

  it('is reported with file:line:col first in pretty form, and does not flood the terminal', async () => {
    const { code, stdout } = await gq(['check', 'invalid'], { cwd });
    expect(code).toBe(1);
    for (const [name, , , place] of INVALID) expect(stdout).toContain(`\ninvalid/${name}.level.json${place}`);
    expect(stdout.length).toBeLessThan(60_000);
    expect(Math.max(...stdout.split('\n').map((line) => line.length))).toBeLessThan(1000);
  });

  it('is refused in the same way by every command that reads one level', async () => {
    const commands = [['simulate'], ['inspect'], ['render', '-o', 'out.svg']];
    const ended = await Promise.all(
      commands.map(([name, ...rest]) => gq([name, 'invalid/unknown-key.level.json', ...rest], { cwd })),
    );
    for (const { code, stdout, stderr } of ended) {
      expect({ code, stdout }).toEqual({ code: 1, stdout: '' });
      expect(stderr).toMatch(/^invalid\/unknown-key\.level\.json:2:1: error unknown-key: .*did you mean "asteroids"/);
    }
    expect(existsSync(join(cwd, 'out.svg'))).toBe(false);
  });

  it('is not changed by fmt', async () => {
    const before = readFileSync(join(cwd, 'invalid/unknown-key.level.json'), 'utf8');
    const { code, stdout } = await gq(['fmt', 'invalid/unknown-key.level.json'], { cwd });
    expect(code).toBe(1);
    expect(stdout).toContain('invalid/unknown-key.level.json:2:1: error');
    expect(readFileSync(join(cwd, 'invalid/unknown-key.level.json'), 'utf8')).toBe(before);
  });
});

it('a level of 100,000 asteroids and one with overlapping holds get a verdict', async () => {
  const { code, stdout, stderr } = await gq(['check', 'fine', '--format', 'json'], { cwd });
  expect(stderr).toBe('');
  const verdicts = JSON.parse(stdout).levels.map((l: { file: string; verdict: string }) => [l.file, l.verdict]);
  expect(verdicts).toContainEqual(['fine/good.level.json', 'completable']);
  expect(verdicts).toContainEqual(['fine/overlapping.level.json', 'completable']);
  expect(verdicts[0][0]).toBe('fine/crowd.level.json');
  expect(verdicts[0][1]).toBe('invalid');
  expect(code).toBe(1);
});

it.each([
  ['merged', 'merge-markers', /the marker "<<<<<<< HEAD", up to ">>>>>>> other" in line 6/, 'git checkout --ours'],
  ['lfs', 'pointer-file', /found a Git LFS pointer \(812 bytes are elsewhere\)/, 'git lfs pull'],
])('what git has left is named in every file beside levels, and in maps: %s', async (folder, code, message, hint) => {
  const said = await Promise.all([
    gq(['check', folder, '--config', `${folder}/gq.config.json`], { cwd }),
    gq(['check', folder, '--no-config', '--lock', `${folder}/gq.lock.json`], { cwd }),
    gq(['check', folder, '--no-config'], { cwd }),
    gq(['fmt', `${folder}/pack.json`], { cwd }),
    gq(['import', `${folder}.tmx`, '--out', 'imported'], { cwd }),
  ]);
  for (const ended of said) {
    expect(ended.code).toBeGreaterThan(0);
    const text = `${ended.stdout}${ended.stderr}`;
    expect(text).toContain(code);
    expect(text).toMatch(message);
    expect(text).toContain(hint);
  }
  expect(existsSync(join(cwd, 'imported'))).toBe(false);
});

it('a byte order mark is a problem with a hint', async () => {
  const checked = await gq(['check', 'bom', '--format', 'json'], { cwd });
  const [level] = JSON.parse(checked.stdout).levels;
  expect(level.problems.map((p: { code: string }) => p.code)).toContain('byte-order-mark');
  expect([level.verdict, checked.code]).toEqual(['invalid', 1]);
});

describe('a path that matches nothing', () => {
  it('is an error that names every such path, even if another path matches, and nothing is checked', async () => {
    const { code, stdout, stderr } = await gq(
      ['check', 'nowhere', 'fine/good.level.json', 'nothing', 'fine/*.lvl', 'fine/god.level.json'],
      { cwd },
    );
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain('  nowhere: no such file or directory\n');
    expect(stderr).toContain('  nothing: the directory contains no *.level.json\n');
    expect(stderr).toContain('  fine/*.lvl: no file matches this pattern\n');
    expect(stderr).toContain('  fine/god.level.json: no such file or directory (did you mean good.level.json?)\n');
    expect(stderr).not.toContain('fine/good.level.json:');
  });

  it('is an error for the default directory, for fmt, and for an empty name', async () => {
    const ended = await Promise.all([gq(['check'], { cwd }), gq(['fmt'], { cwd }), gq(['check', ''], { cwd })]);
    for (const { code, stdout, stderr } of ended) {
      expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
      expect(stderr).toContain('match');
    }
    expect(ended[0].stderr).toContain('levels: no such file or directory');
    expect(ended[2].stderr).toContain('  "": no such file or directory\n');
  });

  it('is an error for commands that read one level, and so is a directory', async () => {
    const [missing, directory] = await Promise.all([
      gq(['simulate', 'fine/goood.level.json'], { cwd }),
      gq(['inspect', 'fine'], { cwd }),
    ]);
    expect(missing).toMatchObject({ code: 2, stdout: '' });
    expect(missing.stderr).toContain(
      "fine/goood.level.json: can't be read: no such file or directory (did you mean good.level.json?)",
    );
    expect(directory).toMatchObject({ code: 2, stdout: '' });
    expect(directory.stderr).toContain("fine: can't be read: is a directory; expected a file");
  });
});

it('invalid holds on the command line are refused with a caret under the place', async () => {
  const { code, stdout, stderr } = await gq(['simulate', 'fine/good.level.json', '--holds', '12-96,90-188'], { cwd });
  expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
  expect(stderr).toContain('\n  12-96,90-188\n        ^ this hold begins at 90, before the previous one ends (96)\n');
});

describe('invalid options', () => {
  const WRONG: readonly [args: string[], message: RegExp][] = [
    [['chek'], /unknown command 'chek'\n\(Did you mean check\?\)/],
    [['check', '--acuracy', 'arcade'], /unknown option '--acuracy'\n\(Did you mean --accuracy\?\)/],
    [['check', '--accuracy', 'perfect'], /'perfect' is invalid.*arcade/],
    [['check', '--format', 'xml'], /'xml' is invalid.*pretty, json, github/],
    [['check', '--jobs', '0'], /'0' is invalid.*a whole number from 1 to 256/],
    [['check', '--max-time', 'soon'], /'soon' is invalid.*expected seconds: more than 0, at most 3600/],
    [['check', '--max-time', '1e999'], /'1e999' is invalid/],
    [['check', '--max-time', '0.001'], /'0\.001' is invalid.*expected seconds: at least one tick \(1\/60 s\), at most/],
    [['simulate'], /missing required argument 'level'/],
    [['simulate', 'a', 'b'], /too many arguments/],
    [['simulate', ''], /^error: "": can't be read/],
    [['import', 'originals.json', '--out', ''], /^error: --out "": expected a folder, found an empty name/],
    [['edit', ''], /^error: "": can't be opened: .*mkdir ""/],
    [['simulate', 'fine/good.level.json', '--sample', '-1'], /'-1' is invalid/],
    [['simulate', 'fine/good.level.json', '--sample', '10000', '--max-time', '3600'], /can give more than 1000000 samples/],
    [['simulate', 'fine/good.level.json', '--recoil', 'maybe'], /'maybe' is invalid.*on, off/],
    [['simulate', 'fine/good.level.json', '--run', 'hodl'], /no run is named "hodl" \(did you mean hold\?\); it has "hold"/],
    [['simulate', 'fine/good.level.json', '--run', 'hold', '--holds', 'none'], /--run and --holds cannot be combined/],
    [['render', 'fine/good.level.json'], /required option '-o, --output <file>'/],
    [['render', 'fine/good.level.json', '-o', 'picture.gif'], /ends in \.svg or \.png/],
    [['import', 'originals.json'], /required option '--out <dir>'/],
    [['explain', 'unknwon-key'], /"unknwon-key" \(did you mean unknown-key\?\)/],
    [[], /Usage: gq/],
  ];

  it('are refused with exit code 2 and a message on stderr only', async () => {
    const ended = await Promise.all(WRONG.map(([args]) => gq(args, { cwd })));
    for (const [i, [args, message]] of WRONG.entries()) {
      const { code, stdout, stderr } = ended[i];
      expect({ code, stdout }, args.join(' ')).toEqual({ code: 2, stdout: '' });
      expect(stderr, args.join(' ')).toMatch(message);
    }
  });
});

describe('an output that cannot be written', () => {
  it('is reported, and no partial file is left behind', async () => {
    const before = readdirSync(cwd);
    const ended = await Promise.all([
      gq(['import', 'originals.json', '--out', 'a-file/levels'], { cwd }),
      gq(['import', 'originals.json', '--out', 'a-file'], { cwd }),
      gq(['render', 'fine/good.level.json', '-o', 'a-file/out.svg'], { cwd }),
      gq(['render', 'fine/good.level.json', '-o', 'nowhere/out.svg'], { cwd }),
    ]);
    for (const { code, stdout, stderr } of ended) {
      expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
      expect(stderr).toMatch(/^error: .*(can't be created|can't be written): .+/);
    }
    expect(readdirSync(cwd)).toEqual(before);
    expect(readFileSync(join(cwd, 'a-file'), 'utf8')).toBe('not a directory');
  });
});

describe('what gq suggests for a path', () => {
  it('is a level file under another name, in a directory without a level', async () => {
    mkdirSync(join(cwd, 'nearly'));
    for (const name of ['far2.json', 'x.level.json.txt'])
      copyFileSync(join(cwd, 'fine/good.level.json'), join(cwd, 'nearly', name));
    for (const name of ['package.json', 'notes.txt']) writeFileSync(join(cwd, 'nearly', name), '{}');
    const { code, stderr } = await gq(['check', 'nearly'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toContain(
      '  nearly: the directory contains no *.level.json; nearly/far2.json looks like a level: did you mean to call it far2.level.json?; ' +
        'nearly/x.level.json.txt looks like a level: did you mean to call it x.level.json?\n',
    );
  });

  it('is where a symbolic link leads that leads nowhere, and not the link itself', async () => {
    mkdirSync(join(cwd, 'links'));
    symlinkSync('nowhere.json', join(cwd, 'links/dangling.level.json'));
    for (const path of ['links', 'links/dangling.level.json']) {
      const ended = await gq(['check', path], { cwd });
      expect(ended.code).toBe(2);
      const said = ended.stdout + ended.stderr;
      expect(said).toContain('links/dangling.level.json');
      expect(said).toContain('; it is a symbolic link to nowhere.json, which leads nowhere');
      expect(said).not.toContain('did you mean');
    }
  });

  it('is the folder on the way that is a link and leads nowhere', async () => {
    mkdirSync(join(cwd, 'ways'));
    symlinkSync('gone', join(cwd, 'ways/lost'));
    symlinkSync('lost', join(cwd, 'ways/far'));
    const { stderr } = await gq(['check', 'ways/lost/a.level.json', 'ways/far'], { cwd });
    expect(stderr).toContain(
      '  ways/lost/a.level.json: no such file or directory; ways/lost is a symbolic link to gone, which leads nowhere\n',
    );
    expect(stderr).toContain('  ways/far: no such file or directory; it is a symbolic link to lost, which leads nowhere\n');
    const edit = await gq(['edit', 'ways/lost'], { cwd });
    expect(edit.stderr).toBe(
      "error: ways/lost: can't be opened: no such file or directory; it is a symbolic link to gone, which leads nowhere; expected a folder of level files\n",
    );
  });

  it('is no file whose name has only the ending in common', async () => {
    const { stderr } = await gq(['check', 'fine/deleted.level.json', 'fine/good.json'], { cwd });
    expect(stderr).toContain('  fine/deleted.level.json: no such file or directory\n');
    expect(stderr).toContain('  fine/good.json: no such file or directory (did you mean good.level.json?)\n');
  });

  it('is to make the folder of a picture', async () => {
    const { code, stderr } = await gq(['render', 'fine/good.level.json', '-o', 'nodir/x.svg'], { cwd });
    expect(code).toBe(2);
    expect(stderr).toBe("error: nodir/x.svg: can't be written: no such file or directory; make the folder nodir first\n");
  });
});

it('gq explain knows the kinds of proof', async () => {
  const { code, stdout } = await gq(['explain', 'out-of-range']);
  expect(code).toBe(0);
  expect(stdout).toMatch(/^out-of-range \(kind of proof\): the object is out of range/);
  for (const part of ['What to do\n', 'docs/proofs.md, "The kinds of proof"']) expect(stdout).toContain(part);
  const { proofs } = JSON.parse((await gq(['explain', '--format', 'json'])).stdout);
  const page = readFileSync(join(import.meta.dirname, '../../docs/proofs.md'), 'utf8');
  for (const { code } of proofs as { code: string }[]) {
    expect(page).toContain(`**\`${code}\`**.`);
    expect((await gq(['explain', code])).code).toBe(0);
  }
});
