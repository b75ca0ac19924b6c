import { execFileSync, spawnSync } from 'node:child_process';
import {
  chmodSync,
  existsSync,
  lstatSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { afterAll, describe, expect, it } from 'vitest';
import { schemaReference } from '../../cli/levels/index.ts';
import { fallThrough, gq, MAIN, makeFiles } from './gq.ts';

const original = {
  player: { x: 0, y: 0 },
  target: { x: 170, y: 0, radius: 18 },
  asteroids: [{ x: 100, y: 0, radius: '16' }],
  maxDistance: 250,
};
const files = makeFiles({
  'originals.json': JSON.stringify([{}, original, { ...original, intro: 'hello' }]),
  'not-originals.json': '[{"player": 3}]',
  'untidy/a.level.json': fallThrough({ 'x-note': { kept: true } }),
  'untidy/b.level.json': `\ufeff${fallThrough()}`,
  'untidy/c.level.json': '{',
});
const cwd = files.directory;
afterAll(files.remove);
const read = (name: string): string => readFileSync(join(cwd, name), 'utf8');

describe('import', () => {
  it('writes level files, reports what it skipped, and never overwrites a different file unasked', async () => {
    const first = await gq(['import', 'originals.json', '--out', 'new/levels'], { cwd });
    expect(first).toMatchObject({ code: 0, stderr: '' });
    const written = readdirSync(join(cwd, 'new/levels')).sort();
    expect(written).toHaveLength(2);
    for (const name of written) expect(first.stdout).toContain(`written new/levels/${name}\n`);
    expect(first.stdout).toMatch(/note: .*skipped/);
    expect(first.stdout).toMatch(/note: .*intro/);
    expect(JSON.parse(read(`new/levels/${written[0]}`))).toMatchObject({
      recoil: true,
      asteroids: [{ x: 100, y: 0, radius: 16 }],
    });

    const again = await gq(['import', 'originals.json', '--out', 'new/levels', '--format', 'json'], { cwd });
    expect(JSON.parse(again.stdout).files.map((f: { status: string }) => f.status)).toEqual(['unchanged', 'unchanged']);

    const precious = join('new/levels', written[1]);
    writeFileSync(join(cwd, precious), 'precious');
    const refused = await gq(['import', 'originals.json', '--out', 'new/levels', '--recoil', 'off'], { cwd });
    expect(refused).toMatchObject({ code: 2, stdout: '' });
    expect(refused.stderr).toContain(`nothing was written`);
    expect(refused.stderr).toContain(precious);
    expect(read(precious)).toBe('precious');
    expect(JSON.parse(read(`new/levels/${written[0]}`)).recoil).toBe(true);

    const forced = await gq(['import', 'originals.json', '--out', 'new/levels', '--recoil', 'off', '--force'], { cwd });
    expect(forced.stdout).toContain(`overwritten ${precious}\n`);
    expect(JSON.parse(read(precious)).recoil ?? false).toBe(false);
    expect(readdirSync(join(cwd, 'new/levels')).sort()).toEqual(written);

    const fmt = await gq(['fmt', '--check', 'new'], { cwd });
    expect(fmt).toMatchObject({ code: 0, stdout: '2 files: 2 unchanged\n' });
  });

  it('names the JSON Schema of the toolkit if the project has installed it, else none', async () => {
    const project = makeFiles({ 'node_modules/gravity-quest-toolkit/schema/level.schema.json': '{}' });
    const ended = await gq(['import', join(cwd, 'originals.json'), '--out', 'a/b'], { cwd: project.directory });
    expect(ended.code).toBe(0);
    const text = readFileSync(join(project.directory, 'a/b/level-01.level.json'), 'utf8');
    const { $schema } = JSON.parse(text);
    expect($schema).toBe('../../node_modules/gravity-quest-toolkit/schema/level.schema.json');
    expect(existsSync(join(project.directory, 'a/b', $schema))).toBe(true);
    project.remove();
    expect(schemaReference(cwd)).toBeNull();
  });

  it('names its own JSON Schema within its own folder', () => {
    const root = fileURLToPath(new URL('../../', import.meta.url));
    expect(schemaReference(join(root, 'levels/new'))).toBe('../../schema/level.schema.json');
    expect(schemaReference(root)).toBe('schema/level.schema.json');
  });

  it('reports problems with their places, and then makes no directory', async () => {
    const { code, stdout, stderr } = await gq(['import', 'not-originals.json', '--out', 'never'], { cwd });
    expect({ code, stdout }).toEqual({ code: 1, stdout: '' });
    expect(stderr).toMatch(/^not-originals\.json:1:\d+: error /);
    expect(existsSync(join(cwd, 'never'))).toBe(false);
  });

  it('removes the files it wrote if a later file cannot be written', async () => {
    // a directory has the name of the second level
    const trap = makeFiles({ 'out/level-02.level.json/x': '' });
    const { code, stderr } = await gq(['import', join(cwd, 'originals.json'), '--out', 'out'], { cwd: trap.directory });
    expect(code).toBe(2);
    expect(stderr).toMatch(/out\/level-02\.level\.json: .*(is a directory)/);
    expect(readdirSync(join(trap.directory, 'out'))).toEqual(['level-02.level.json']);
    trap.remove();
  });
});

describe('fmt', () => {
  it('rewrites only files that are not canonical, keeps modes and x- keys, and does not change invalid files', async () => {
    chmodSync(join(cwd, 'untidy/a.level.json'), 0o640);
    const before = read('untidy/a.level.json');
    const only = await gq(['fmt', '--check', 'untidy'], { cwd });
    expect(only.code).toBe(1);
    expect(only.stdout).toContain(
      'would change untidy/a.level.json\nwould change untidy/b.level.json\ninvalid untidy/c.level.json\nuntidy/c.level.json:1:2: error',
    );
    expect(read('untidy/a.level.json')).toBe(before);

    const done = await gq(['fmt', 'untidy', '--format', 'json'], { cwd });
    expect(done.code).toBe(1);
    expect(JSON.parse(done.stdout).files.map((f: { status: string }) => f.status)).toEqual(['formatted', 'formatted', 'invalid']);
    expect(read('untidy/a.level.json')).not.toBe(before);
    const { asteroids, ...rest } = JSON.parse(read('untidy/a.level.json'));
    const { asteroids: unnamed, ...others } = JSON.parse(before);
    expect(rest).toEqual(others);
    expect(asteroids).toEqual([{ ...unnamed[0], id: expect.stringMatching(/^[a-z0-9]{2,16}$/) }]);
    expect(statSync(join(cwd, 'untidy/a.level.json')).mode & 0o777).toBe(0o640);
    expect(read('untidy/b.level.json').charCodeAt(0)).toBe('{'.charCodeAt(0));
    expect(read('untidy/c.level.json')).toBe('{');

    const { mtimeMs } = statSync(join(cwd, 'untidy/a.level.json'));
    const again = await gq(['fmt', 'untidy/a.level.json', 'untidy/b.level.json'], { cwd });
    expect(again).toMatchObject({ code: 0, stdout: '2 files: 2 unchanged\n' });
    expect(statSync(join(cwd, 'untidy/a.level.json')).mtimeMs).toBe(mtimeMs);
  });
});

describe.runIf(process.platform !== 'win32')('special files', () => {
  const place = makeFiles({
    'a.level.json': fallThrough(),
    'b.level.json': fallThrough(),
    'originals.json': JSON.stringify([original, original]),
    'all/x.level.json': fallThrough(),
  });
  const here = place.directory;
  afterAll(place.remove);
  const at = (name: string): string => join(here, name);
  const run = (args: string) => gq(args.split(' '), { cwd: here });

  it('a broken link is followed, and the new file has the usual mode', async () => {
    symlinkSync('later.svg', at('first.svg'));
    symlinkSync('first.svg', at('link.svg'));
    expect(await run('render a.level.json -o link.svg')).toMatchObject({ code: 0 });
    expect(lstatSync(at('link.svg')).isSymbolicLink()).toBe(true);
    expect(lstatSync(at('later.svg')).isFile()).toBe(true);
    expect(statSync(at('later.svg')).mode & 0o777).toBe(0o666 & ~process.umask());
    symlinkSync('nowhere/x.svg', at('lost.svg'));
    symlinkSync('ring.svg', at('ring.svg'));
    for (const [name, why] of [
      ['lost.svg', 'no such file or directory'],
      ['ring.svg', 'its symbolic links go round in circles'],
    ]) {
      const { code, stderr } = await run(`render a.level.json -o ${name}`);
      expect({ code, stderr }).toEqual({ code: 2, stderr: `error: ${name}: can't be written: ${why}\n` });
      expect(lstatSync(at(name)).isSymbolicLink()).toBe(true);
    }
  });

  it('a read-only file is not changed, even by root', async () => {
    const text = readFileSync(at('b.level.json'), 'utf8');
    const texts = { 'b.level.json': text, 'drawn.svg': '<svg/>', 'level-01.level.json': text };
    for (const [name, content] of Object.entries(texts)) {
      if (name !== 'b.level.json') writeFileSync(at(name), content);
      chmodSync(at(name), 0o444);
    }
    const [fmt, solve, render, imported] = await Promise.all([
      run('fmt b.level.json'),
      run('solve b.level.json --write --effort 1000'),
      run('render a.level.json -o drawn.svg'),
      run('import originals.json --out . --force'),
    ]);
    expect(fmt).toMatchObject({ code: 2, stdout: '1 file: 1 failed\n' });
    expect(fmt.stderr).toMatch(/^error: b\.level\.json: can't be written: .+\n$/);
    for (const { code, stderr } of [solve, render, imported]) {
      expect(code).toBe(2);
      expect(stderr).toMatch(/writ.*(?:read-only \(mode 444\)|permission denied)/);
    }
    for (const [name, content] of Object.entries(texts)) expect(readFileSync(at(name), 'utf8')).toBe(content);
    expect(existsSync(at('level-02.level.json'))).toBe(false);
    expect(readdirSync(here).filter((name) => name.includes('tmp'))).toEqual([]);
  });

  it('a named pipe, a socket, an endless device and a folder never make a command wait', async () => {
    execFileSync('mkfifo', [at('pipe'), at('all/pipe.level.json'), at('package.json')]);
    mkdirSync(at('folder.level.json'));
    symlinkSync('/dev/zero', at('zero'));
    symlinkSync('pipe', at('to-pipe'));
    const socket = createServer().listen(at('socket'));
    for (const [name, why] of [
      ['pipe', /it is a named pipe, not a regular file; expected a file, or \/dev\/stdin/],
      ['to-pipe', /it is a named pipe/],
      ['socket', /socket/],
      ['zero', /larger than|file-too-large/],
      ['folder.level.json', /is a directory|it is a folder|contains no/],
    ] as const) {
      for (const command of ['check', 'simulate', 'solve', 'fmt', 'difficulty', 'import --out out']) {
        const { code, stdout, stderr, signal } = await run(`${command} ${name}`);
        expect(signal, `${command} ${name}`).toBeNull();
        expect(code, `${command} ${name}`).toBe(name === 'zero' ? 1 : 2);
        expect(stdout + stderr).toMatch(why);
      }
    }
    socket.close();
    expect(await run('check all')).toMatchObject({ code: 0 });
    // import looks for the surrounding project and for existing files
    execFileSync('mkfifo', [at('pipes.level.json')]);
    mkdirSync(at('taken'));
    execFileSync('mkfifo', [at('taken/level-01.level.json')]);
    expect(await run('import originals.json --out taken --force')).toMatchObject({ code: 2 });
    expect(await run('import originals.json --out new/deep')).toMatchObject({ code: 0 });
  });

  it.runIf(process.platform === 'linux')('a name that is not UTF-8 is reported, and the rest is checked', async () => {
    mkdirSync(at('odd'));
    for (const name of ['ok.level.json', Buffer.from([0x6f, 0xff, ...Buffer.from('.level.json')])]) {
      writeFileSync(Buffer.concat([Buffer.from(`${at('odd')}/`), Buffer.from(name)]), fallThrough());
    }
    const { code, stdout } = await run('check odd');
    expect(code).toBe(2);
    expect(stdout).toContain('its name is not UTF-8: rename it');
    expect(stdout).toContain('2 levels: 1 completable, 1 invalid');
  });

  it('a pipe of the shell is read to its end', () => {
    const script = '"$0" "$1" check <(cat a.level.json) <(cat a.level.json) && cat a.level.json | "$0" "$1" simulate /dev/stdin';
    const { status, stdout } = spawnSync('bash', ['-c', script, process.execPath, MAIN], { cwd: here, encoding: 'utf8' });
    expect(stdout).toContain('2 levels: 2 completable');
    expect(stdout).toContain('completed at');
    expect(status).toBe(0);
  });

  it('fmt counts the files that fail', async () => {
    mkdirSync(at('lost'));
    symlinkSync('nowhere', at('lost/gone.level.json'));
    const { code, stdout, stderr } = await run('fmt lost all/x.level.json');
    expect({ code, stdout }).toEqual({ code: 2, stdout: 'formatted all/x.level.json\n2 files: 1 formatted, 1 failed\n' });
    expect(stderr).toMatch(/^error: lost\/gone\.level\.json: can't be read: no such file or directory/);
    expect(await run('fmt lost')).toMatchObject({ code: 2, stdout: '1 file: 1 failed\n' });
    const json = JSON.parse((await run('fmt lost --format json')).stdout);
    expect(json).toEqual({ version: 1, files: [{ file: 'lost/gone.level.json', status: 'failed', problems: [] }] });
  });
});

it('reports the number of problems that are not shown', async () => {
  const novae = Array.from({ length: 3000 }, (_, i) => ({ x: 40 * i, y: 5000, radius: 'wide' }));
  const crowd = Array.from({ length: 60 }, (_, i) => ({ x: i, y: 5000, radius: 16 }));
  writeFileSync(join(cwd, 'wrong.level.json'), fallThrough({ novae }));
  writeFileSync(join(cwd, 'crowd.level.json'), fallThrough({ novae: crowd }));
  const wrong = await gq(['check', 'wrong.level.json'], { cwd });
  expect(wrong.stdout).toContain('more-problems: and at least 980 more\n');
  expect(wrong.stdout).not.toContain('1 more problem');
  const crowded = await gq(['check', 'crowd.level.json'], { cwd });
  expect(crowded.stdout).toContain('overlapping: the level has more warnings of this kind: only the first 20 are listed\n');
  expect(crowded.stdout).not.toContain('1 more problem');
});

describe('render', () => {
  it('writes SVG and PNG, and SVG to stdout', async () => {
    const level = 'untidy/a.level.json';
    const [svg, png, out, bare] = await Promise.all([
      gq(['render', level, '-o', 'run.svg', '--accuracy', 'arcade'], { cwd }),
      gq(['render', level, '-o', 'RUN.PNG', '--width', '320', '--theme', 'light'], { cwd }),
      gq(['render', level, '-o', '-', '--accuracy', 'arcade'], { cwd }),
      gq(['render', level, '-o', '-', '--no-run'], { cwd }),
    ]);
    expect([svg, png, out, bare].map(({ code }) => code)).toEqual([0, 0, 0, 0]);
    expect(svg).toMatchObject({ stdout: '', stderr: 'wrote run.svg\n' });
    expect(read('run.svg')).toBe(out.stdout);
    expect(out.stdout).toMatch(/^<svg .*<\/svg>\n$/s);
    expect(bare.stdout).not.toBe(out.stdout);
    const bytes = readFileSync(join(cwd, 'RUN.PNG'));
    expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    expect(bytes.readUInt32BE(16)).toBe(320);
  });
});

it.runIf(process.platform !== 'win32')('the old file stays whole if the disk has room for only a part of the new one', () => {
  const novae = Array.from({ length: 120 }, (_, i) => ({ x: 40 * i, y: 5000, radius: 16 }));
  const compact = fallThrough({ novae });
  writeFileSync(join(cwd, 'crowded.level.json'), compact);
  // the kernel's limit for file sizes, KiB: it writes what fits and refuses the rest, like a full disk
  const script = `trap '' XFSZ; ulimit -f 5; exec "$0" "$1" fmt crowded.level.json`;
  const { status, stderr } = spawnSync('bash', ['-c', script, process.execPath, MAIN], { cwd, encoding: 'utf8' });
  expect(stderr).toMatch(/crowded\.level\.json: can't be written: /);
  expect(status).toBe(2);
  expect(read('crowded.level.json')).toBe(compact);
  expect(readdirSync(cwd).filter((name) => name.includes('tmp'))).toEqual([]);
});

it('schema prints the published JSON Schema', async () => {
  const { code, stdout } = await gq(['schema']);
  expect(code).toBe(0);
  expect(JSON.parse(stdout)).toMatchObject({ $schema: expect.stringContaining('json-schema.org'), type: 'object' });
});
