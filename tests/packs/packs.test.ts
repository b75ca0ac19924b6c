import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { gzipSync } from 'node:zlib';
import fc from 'fast-check';
import { create, Header, replace } from 'tar';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { BatchMaker, sizeOf, unwrap } from '../../cli/io/packs/batch.ts';
import { readTar } from '../../cli/io/packs/tar-archive.ts';
import { fallThrough, gq, makeFiles } from '../cli/gq.ts';
import { itQuick } from '../depth.ts';

let place: ReturnType<typeof makeFiles>;
beforeAll(() => {
  place = makeFiles({});
});
afterAll(() => place.remove());

const put = (name: string, content: string | Uint8Array): void => writeFileSync(join(place.directory, name), content);

/** The verdicts on the levels of a pack, by name. */
async function verdicts(...paths: readonly string[]): Promise<Record<string, string>> {
  const { stdout, stderr } = await gq(['check', ...paths, '--format', 'json'], { cwd: place.directory });
  if (stdout === '') throw new Error(stderr);
  return Object.fromEntries(JSON.parse(stdout).levels.map(({ file, verdict }: Record<string, string>) => [file, verdict]));
}

const refusal = async (path: string): Promise<string> => {
  const { code, stdout, stderr } = await gq(['check', path], { cwd: place.directory });
  expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
  return stderr;
};

const LEVEL = fallThrough();

describe('a pack whose content git has not fetched', () => {
  const pointer = 'version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 123456\n';

  it.each(['p.ndjson', 'p.tar', 'p.tgz', 'p.ndjson.gz', 'p.tar.zst'])('is refused as what it is: %s', async (name) => {
    put(name, pointer);
    const said = `error: ${name}: expected a pack, found a Git LFS pointer (123456 bytes are elsewhere). Run git lfs install`;
    expect(await refusal(name)).toContain(said);
    const one = await gq(['simulate', `${name}#1`], { cwd: place.directory });
    expect(one).toMatchObject({ code: 2, stdout: '', stderr: expect.stringContaining(said) });
  });

  it('is no pack of one short level', async () => {
    put('short.ndjson', '{"version": 1}');
    expect(await verdicts('short.ndjson')).toEqual({ 'short.ndjson#1': 'invalid' });
  });
});

describe('a pack of lines', () => {
  it('has no level where a line says two', async () => {
    const other = fallThrough({ name: 'Other' });
    const lines = [
      `{"level":${LEVEL},"level":${other}}`,
      `{"id":1,"id":2,"level":${LEVEL}}`,
      `{"level":${LEVEL},"id":"a","id":"b"}`,
    ];
    put('twice.ndjson', lines.join('\n'));
    expect(Object.values(await verdicts('twice.ndjson'))).toEqual(['invalid', 'invalid', 'invalid']);
  });

  it('has a level in each line that is not blank, named by its number', async () => {
    put('a.ndjson', `${LEVEL}\r\n\n  \t\n{"version": 1}\n\u00ff\n${fallThrough({ runs: [] })}`);
    expect(await verdicts('a.ndjson')).toEqual({
      'a.ndjson#1': 'completable',
      'a.ndjson#4': 'invalid',
      'a.ndjson#5': 'invalid',
      'a.ndjson#6': 'unproven',
    });
  });

  it('takes ids in either order, and anything else for a level', async () => {
    const lines = [
      `{"id": "one", "level": ${LEVEL}}`,
      `{"level":${LEVEL},"id":2}`,
      `{"level": ${LEVEL} }`,
      `  { "id" : "caf\\u00e9 \\"x\\"" , "level" : ${LEVEL} }  `,
      `{"id": "one", "level": ${LEVEL}, "more": 1}`,
      `{"id": {}, "level": ${LEVEL}}`,
      `{"id": "a", "level": ${LEVEL}, "id": "b"}`,
    ];
    put('ids.ndjson', lines.join('\n'));
    expect(await verdicts('ids.ndjson')).toEqual({
      'ids.ndjson#one': 'invalid',
      'ids.ndjson#2': 'completable',
      'ids.ndjson#3': 'completable',
      'ids.ndjson#café "x"': 'completable',
      'ids.ndjson#6': 'invalid',
      'ids.ndjson#7': 'invalid',
    });
  });

  it('unwraps just what a JSON reader finds', () => {
    const id = fc.oneof(fc.string({ maxLength: 30 }), fc.integer());
    const level = fc.jsonValue({ maxDepth: 3 }).map((value) => ({ level: value, id: 'inner', name: '"},{' }));
    const space = fc.constantFrom('', ' ', '\t ');
    fc.assert(
      fc.property(id, level, space, fc.boolean(), (name, inside, gap, isFirst) => {
        const text = JSON.stringify(inside);
        const own = `"id"${gap}:${gap}${JSON.stringify(name)}`;
        const body = `"level"${gap}:${gap}${text}`;
        const line = `${gap}{${gap}${isFirst ? own : body}${gap},${gap}${isFirst ? body : own}${gap}}${gap}`;
        const { id: found, content } = unwrap(Buffer.from(line));
        expect(found).toBe(String(name));
        expect(Buffer.from(content).toString().trimEnd()).toBe(text);
      }),
    );
  });

  itQuick('reads lines that are longer than any level without keeping them', async () => {
    put('long.ndjson', `${LEVEL}\n${'['.repeat(6_000_000)}\n${' '.repeat(3_000_000)}\n${LEVEL}\n`);
    const found = await verdicts('long.ndjson');
    expect(found['long.ndjson#1']).toBe('completable');
    expect(found['long.ndjson#2']).toBe('invalid');
    expect(found['long.ndjson#4']).toBe('completable');
  });

  it('reads compressed ones, also of several parts', async () => {
    put('z.ndjson.gz', Buffer.concat([gzipSync(`${LEVEL}\n`), gzipSync(`${LEVEL}\n`)]));
    expect(await verdicts('z.ndjson.gz')).toEqual({ 'z.ndjson.gz#1': 'completable', 'z.ndjson.gz#2': 'completable' });
  });

  it('is refused when it is empty, cut off, or packed in another way than its name says', async () => {
    put('empty.ndjson', '\n \n');
    expect(await refusal('empty.ndjson')).toBe('error: empty.ndjson: it contains no level: expected a level a line\n');
    put('cut.ndjson.gz', gzipSync(`${LEVEL}\n`.repeat(50)).subarray(0, -12));
    expect(await refusal('cut.ndjson.gz')).toContain("cut.ndjson.gz: can't be unpacked (gzip): unexpected end of file");
    put('plain.ndjson.gz', LEVEL);
    expect(await refusal('plain.ndjson.gz')).toContain("plain.ndjson.gz: can't be unpacked (gzip): incorrect header check");
    put('z.ndjson.zst', LEVEL);
    expect(await refusal('z.ndjson.zst')).toContain('zstd');
  });
});

describe('an archive', () => {
  const long = `${'deep/'.repeat(40)}ünïcode ${'x'.repeat(60)}.level.json`;

  it('has the level files in it, whatever their names', async () => {
    const inside = makeFiles({ 'a.level.json': LEVEL, [long]: fallThrough({ runs: [] }), 'README.md': 'x', 'b.json': LEVEL });
    try {
      for (const [name, options] of [
        ['t.tar', {}],
        ['t.tgz', { gzip: true }],
        ['t.tar.gz', { gzip: true }],
      ] as const) {
        await create({ cwd: inside.directory, file: join(place.directory, name), ...options }, ['.']);
        const found = await verdicts(name);
        expect(Object.values(found).sort()).toEqual(['completable', 'unproven']);
        expect(Object.keys(found).some((key) => key.endsWith(long))).toBe(true);
      }
    } finally {
      inside.remove();
    }
  });

  it('is refused when it is cut off, damaged, or has no level', async () => {
    const inside = makeFiles({ 'a.level.json': LEVEL.padEnd(3000), 'b.txt': 'x' });
    try {
      const file = join(place.directory, 'whole.tar');
      await create({ cwd: inside.directory, file }, ['a.level.json']);
      const { readFileSync } = await import('node:fs');
      const bytes = readFileSync(file);
      put('cut.tar', bytes.subarray(0, 2000));
      expect(await refusal('cut.tar')).toContain(
        'cut.tar: the archive is cut off: expected two blocks of zeros, with which an archive ends, found the end of its data at byte 2000, after the entry a.level.json',
      );
      put('garbage.tar', Buffer.alloc(4096, 'garbage '));
      expect(await refusal('garbage.tar')).toContain('garbage.tar: it is no tar archive');
      await create({ cwd: inside.directory, file: join(place.directory, 'none.tar') }, ['b.txt']);
      expect(await refusal('none.tar')).toContain('none.tar: it contains no level: expected *.level.json in it');
      put('empty.tar', '');
      expect(await refusal('empty.tar')).toContain('empty.tar: the archive is cut off');
    } finally {
      inside.remove();
    }
  });

  const block = (type: 'File' | 'Link' | 'SymbolicLink', path: string, content = ''): Buffer => {
    const head = Buffer.alloc(512);
    new Header({
      path,
      size: content.length,
      mode: 0o644,
      type,
      linkpath: type === 'File' ? '' : 'a.level.json',
      mtime: new Date(0),
    }).encode(head, 0);
    return Buffer.concat([head, Buffer.alloc(512 * Math.ceil(content.length / 512)).fill(content, 0, content.length)]);
  };
  const END = Buffer.alloc(1024);

  it.each([
    ['Link', 'a hard link: pack it with tar --hard-dereference'],
    ['SymbolicLink', 'a symbolic link: pack it with tar --dereference'],
  ] as const)('is refused when a level in it is a %s: it would be left out unnoticed', async (type, message) => {
    put('links.tar', Buffer.concat([block('File', 'a.level.json', LEVEL), block(type, 'b.level.json'), END]));
    expect(await refusal('links.tar')).toContain(`expected only files of that name, found b.level.json, which is ${message}`);
    // of other names it does not matter
    put('links.tar', Buffer.concat([block('File', 'a.level.json', LEVEL), block(type, 'latest'), END]));
    expect(Object.values(await verdicts('links.tar'))).toEqual(['completable']);
  });

  it('is refused when another is joined to it, wherever the pieces in which it is read end', async () => {
    const one = Buffer.concat([block('File', 'a.level.json', LEVEL), END]);
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.integer({ min: 1, max: 2 * one.length }), { maxLength: 8 }),
        fc.boolean(),
        async (cuts, isTwo) => {
          const bytes = isTwo ? Buffer.concat([one, one]) : Buffer.concat([one, Buffer.alloc(one.length)]);
          const places = [0, ...[...new Set(cuts)].sort((a, b) => a - b).filter((at) => at < bytes.length), bytes.length];
          async function* pieces() {
            for (let i = 1; i < places.length; i++) yield bytes.subarray(places[i - 1], places[i]);
          }
          const maker = new BatchMaker('x.tar', 'tar', 0, { entries: 100, bytes: 1e6 });
          const read = async (): Promise<number> => {
            let count = 0;
            for await (const batch of readTar('x.tar', pieces(), maker, () => true)) count += sizeOf(batch);
            return count;
          };
          if (isTwo) await expect(read()).rejects.toThrow('there is more after the end of the archive');
          else expect(await read()).toBe(1);
        },
      ),
    );
  });

  it('is refused when it is packed with gzip, and its name does not say so', async () => {
    put('packed.tar', gzipSync(Buffer.concat([block('File', 'a.level.json', LEVEL), END])));
    expect(await refusal('packed.tar')).toContain(
      'packed.tar: it is packed with gzip: expected a name that ends in .tgz or .tar.gz',
    );
  });

  it('shows names that could change the terminal', async () => {
    const header = new Header({
      path: 'a\u001b[31m\n.level.json',
      size: LEVEL.length,
      mode: 0o644,
      type: 'File',
      mtime: new Date(0),
    });
    const block = Buffer.alloc(512);
    header.encode(block, 0);
    put('odd.tar', Buffer.concat([block, Buffer.from(LEVEL.padEnd(512)), Buffer.alloc(1024)]));
    const { stdout, code } = await gq(['check', 'odd.tar'], { cwd: place.directory });
    expect(code).toBe(0);
    expect(stdout).not.toContain('\u001b');
    expect(stdout.split('\n')[0]).toContain('.level.json');
  });
});

// opening one waits for its writer, and nobody may ever write
it.skipIf(process.platform === 'win32')('a pack that is a pipe is refused', async () => {
  execFileSync('mkfifo', [join(place.directory, 'pipe.ndjson')]);
  for (const args of [
    ['check', 'pipe.ndjson'],
    ['plan', 'pipe.ndjson', '--shards', '2'],
    ['simulate', 'pipe.ndjson#1'],
  ]) {
    const { code, stderr } = await gq(args, { cwd: place.directory });
    expect(code).toBe(2);
    expect(stderr).toContain("can't be read: it is a named pipe, not a regular file; expected a file");
  }
});

describe('an entry of a pack', () => {
  it('is a level for every command, by the name that it has in reports', async () => {
    put('e.ndjson', `${LEVEL}\n{"id": "x", "level": ${fallThrough({ name: 'Second' })}}\n`);
    const simulate = (name: string) => gq(['simulate', name], { cwd: place.directory });
    expect((await simulate('e.ndjson#1')).stdout).toContain('Straight through');
    expect((await simulate('e.ndjson#x')).stdout).toContain('Second');
    expect((await simulate('e.ndjson#2')).stdout).toContain('Second');
    expect(await simulate('e.ndjson#3')).toMatchObject({
      code: 2,
      stderr: 'error: e.ndjson#3: the pack has no such line or id\n',
    });
    for (const name of ['e.ndjson#1', 'e.ndjson#x']) expect(await verdicts(name)).toEqual({ [name]: 'completable' });
    expect(await gq(['check', 'e.ndjson#3'], { cwd: place.directory })).toMatchObject({
      code: 2,
      stdout: expect.stringContaining('the pack has no such line or id'),
    });
    expect((await simulate('gone.ndjson#3')).stderr).toContain('no such file or directory');
    // packs are read only
    for (const write of [['fmt'], ['solve', '--write', '--effort', '1']]) {
      const { code, stderr } = await gq([...write, 'e.ndjson#x'], { cwd: place.directory });
      expect(code).toBe(2);
      expect(stderr).toContain('it is in the pack e.ndjson: take it out first');
    }
    expect(existsSync(join(place.directory, 'e.ndjson#x'))).toBe(false);
    // a file whose name looks like one is a file
    put('e.ndjson#9', fallThrough({ name: 'A file' }));
    expect((await simulate('e.ndjson#9')).stdout).toContain('A file');
  });
});

describe('names that several levels have', () => {
  it('are for no single one of them', async () => {
    const other = fallThrough({ name: 'Second' });
    put(
      'd.ndjson',
      [`{"id": "x", "level": ${LEVEL}}`, `{"id": "x", "level": ${other}}`, `{"id": 4, "level": ${LEVEL}}`, other].join('\n'),
    );
    const simulate = (name: string) => gq(['simulate', name], { cwd: place.directory });
    for (const [name, lines] of [
      ['d.ndjson#x', '1, 2'],
      ['d.ndjson#4', '3, 4'],
    ]) {
      const { code, stderr } = await simulate(name);
      expect(code).toBe(2);
      expect(stderr).toContain(`${name}: expected one level of that name, found lines ${lines}`);
    }
    expect((await simulate('d.ndjson#2')).stdout).toContain('Second');
    // as tar --append does it
    mkdirSync(join(place.directory, 'twice'), { recursive: true });
    for (const [i, text] of [LEVEL, other].entries()) {
      put('twice/a.level.json', text);
      const archive = { cwd: place.directory, file: join(place.directory, 'd.tar') };
      await (i === 0 ? create(archive, ['twice/a.level.json']) : replace(archive, ['twice/a.level.json']));
    }
    const { code, stderr } = await simulate('d.tar#twice/a.level.json');
    expect(code).toBe(2);
    expect(stderr).toContain('expected one level of that name, found 2 files');
  });

  it('a blank line has none', async () => {
    put('blank.ndjson', `${LEVEL}\n \r\n${LEVEL}`);
    const { code, stderr } = await gq(['simulate', 'blank.ndjson#2'], { cwd: place.directory });
    expect(code).toBe(2);
    expect(stderr).toContain('the pack has no such line or id');
  });

  it('lead to no other file, whatever they are', async () => {
    put('dots.ndjson', `{"id": "/../../other", "level": ${fallThrough({ runs: [] })}}`);
    for (const format of ['junit', 'sarif']) {
      const { stdout } = await gq(['check', 'dots.ndjson', '--format', format], { cwd: place.directory });
      expect(stdout).toMatch(format === 'junit' ? /file="dots.ndjson#\/..\/..\/other"/ : /"dots.ndjson%23\/..\/..\/other"/);
    }
  });
});

it('gq fmt leaves packs as they are', async () => {
  put('one.ndjson', LEVEL);
  for (const options of [[], ['--check']]) {
    const { code, stderr } = await gq(['fmt', 'one.ndjson', ...options], { cwd: place.directory });
    expect(code).toBe(2);
    expect(stderr).toContain('one.ndjson: it is a pack: expected level files');
  }
  expect(readFileSync(join(place.directory, 'one.ndjson'), 'utf8')).toBe(LEVEL);
});

describe('options for files', () => {
  it.each([
    [['--changed'], '--changed is for level files'],
    [['--bail', '1'], '--bail is for level files'],
    [['--update-lock'], '--update-lock is for level files'],
    [['--watch'], '--watch is for level files'],
    [['--lock', 'l.json'], 'the lock l.json is for level files'],
    [['--shard', '1'], '--shard is for a shard of a plan'],
    [['--out', 'o'], '--out is for a shard of a plan'],
    [['--plan', 'p.json'], '--plan: expected --shard with it'],
    [['--plan', 'p.json', '--shard', '0'], '--plan: expected --out DIR with it'],
    [['--plan', 'p.json', '--shard', '0', '--out', 'o'], 'the plan has the paths: expected none with --plan, found'],
  ])('%j is refused with a pack', async (options, message) => {
    put('o.ndjson', LEVEL);
    const { code, stderr } = await gq(['check', 'o.ndjson', ...options], { cwd: place.directory });
    expect(code).toBe(2);
    expect(stderr).toContain(message);
  });
});
