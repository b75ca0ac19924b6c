import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Readable } from 'node:stream';
import * as zlib from 'node:zlib';
import fc from 'fast-check';
import { create } from 'tar';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { BatchMaker, sizeOf } from '../../cli/io/packs/batch.ts';
import { readEntry, readSet } from '../../cli/io/packs/index.ts';
import { ZstdFrame } from '../../cli/io/packs/open-pack.ts';
import { readTar } from '../../cli/io/packs/tar-archive.ts';
import { Failure } from '../../cli/terminal/messages.ts';
import { fallThrough, gq, makeFiles } from '../cli/gq.ts';

let place: ReturnType<typeof makeFiles>;
/** An archive without bytes after its end. */
let whole: Buffer;
const NAMES = ['a.level.json', `${'deep/'.repeat(30)}b.level.json`, 'notes.txt', 'c.level.json'];

beforeAll(async () => {
  place = makeFiles({});
  const inside = makeFiles(Object.fromEntries(NAMES.map((name, i) => [name, fallThrough().padEnd(400 * i)])));
  const file = join(place.directory, 'whole.tar');
  await create({ cwd: inside.directory, file, portable: true }, NAMES);
  inside.remove();
  const bytes = readFileSync(file);
  const content = bytes.findLastIndex((byte) => byte !== 0) + 1;
  whole = bytes.subarray(0, 512 * Math.ceil(content / 512) + 1024);
});
afterAll(() => place.remove());

/** How many files an archive has, that is read in two pieces. */
async function countFiles(bytes: Buffer, at: number): Promise<number> {
  const maker = new BatchMaker('x.tar', 'tar', 0, { entries: 100, bytes: 1e6 });
  let count = 0;
  for await (const batch of readTar('x.tar', Readable.from([bytes.subarray(0, at), bytes.subarray(at)]), maker, () => true))
    count += sizeOf(batch);
  return count;
}

/** The levels of a pack with these bytes. */
async function countLevels(name: string, bytes: Uint8Array): Promise<number> {
  const path = join(place.directory, name);
  writeFileSync(path, bytes);
  let count = 0;
  for await (const batch of readSet([path], 'levels', { entries: 100, bytes: 1e6 })) count += sizeOf(batch);
  return count;
}

describe('an archive', () => {
  it('is refused wherever it is cut, up to the last byte of its end', async () => {
    expect(await countFiles(whole, 0)).toBe(NAMES.length);
    const end = fc.oneof(
      fc.integer({ min: 0, max: whole.length - 1 }),
      // at the boundaries of blocks and beside them
      fc
        .tuple(fc.integer({ min: 0, max: whole.length / 512 - 1 }), fc.integer({ min: 0, max: 1 }))
        .map(([block, off]) => 512 * block + off),
    );
    await fc.assert(
      fc.asyncProperty(end, fc.nat(), async (length, at) => {
        await expect(countFiles(whole.subarray(0, length), at % (length + 1))).rejects.toBeInstanceOf(Failure);
      }),
      { numRuns: 300 },
    );
  });

  it('says where it ends and what to do', async () => {
    // its end alone is missing: every file is there
    await expect(countFiles(whole.subarray(0, -1024), 7)).rejects.toThrow(
      `x.tar: the archive is cut off: expected two blocks of zeros, with which an archive ends, found the end of its data at byte ${whole.length - 1024}, after the entry c.level.json: files may be missing; copy or pack it again`,
    );
    await expect(countFiles(whole.subarray(0, -512), 7)).rejects.toThrow('the archive is cut off');
    await expect(countFiles(Buffer.alloc(0), 0)).rejects.toThrow('found the end of its data at byte 0: files may be missing');
    await expect(countFiles(Buffer.concat([whole, Buffer.from('more')]), 7)).rejects.toThrow('there is more after the end');
    // as many archives have it, which end at a multiple of 10240 bytes
    expect(await countFiles(Buffer.concat([whole, Buffer.alloc(5000)]), 7)).toBe(NAMES.length);
  });

  it.each(['check', 'plan', 'shard', 'entry'])('gq ends with 2 for one that is cut: %s', async (how) => {
    const folder = join(place.directory, how);
    const run = (...args: string[]) => gq(args, { cwd: folder });
    mkdirSync(folder);
    writeFileSync(join(folder, 'a.tar'), whole);
    expect((await run('plan', 'a.tar', '--shards', '1', '-o', 'plan.json')).code).toBe(0);
    for (const end of [whole.length - 512, whole.length - 1024, 512 * 3 + 100]) {
      writeFileSync(join(folder, 'a.tar'), whole.subarray(0, end));
      const { code, stderr } = await {
        check: () => run('check', 'a.tar'),
        plan: () => run('plan', 'a.tar', '--shards', '1', '-o', `plan-${end}.json`),
        shard: () => run('check', '--plan', 'plan.json', '--shard', '0', '--out', 'out'),
        entry: () => run('simulate', 'a.tar#a.level.json'),
      }[how as 'check' | 'plan' | 'shard' | 'entry']();
      expect({ code, cut: /cut off/.test(stderr) }, stderr).toEqual({ code: 2, cut: true });
    }
  });

  it('is refused when it is packed and either of both is cut', async () => {
    const packed = zlib.gzipSync(whole);
    expect(await countLevels('a.tgz', packed)).toBe(3);
    await expect(countLevels('a.tgz', packed.subarray(0, -1))).rejects.toThrow('unexpected end of file; it may be cut off');
    await expect(countLevels('a.tgz', zlib.gzipSync(whole.subarray(0, -1024)))).rejects.toThrow('the archive is cut off');
  });
});

describe('a pack of lines as gzip', () => {
  it('is refused when more comes after the zeros at its end, which gunzip leaves out', async () => {
    const line = zlib.gzipSync(`${fallThrough()}\n`);
    expect(await countLevels('a.ndjson.gz', Buffer.concat([line, line, Buffer.alloc(3)]))).toBe(2);
    const bytes = Buffer.concat([line, Buffer.alloc(3), line]);
    const message = "can't be unpacked (gzip): there is more after the zeros at its end; it may be cut off or damaged";
    await expect(countLevels('a.ndjson.gz', bytes)).rejects.toThrow(message);
    expect(() => readEntry(join(place.directory, 'a.ndjson.gz'), '1')).toThrow(message);
  });
});

/** A zstd frame of raw and repeated blocks, which needs no packing. */
function frameOf(blocks: readonly (string | { readonly byte: number; readonly times: number })[], isSingle: boolean): Buffer {
  const sizes = blocks.map((block) => (typeof block === 'string' ? Buffer.byteLength(block) : block.times));
  const total = sizes.reduce((sum, size) => sum + size, 0);
  const length = Buffer.alloc(4);
  length.writeUInt32LE(total);
  const head = isSingle
    ? [0x28, 0xb5, 0x2f, 0xfd, 0xa0, ...length]
    : // a window of 8 MiB, and no length
      [0x28, 0xb5, 0x2f, 0xfd, 0x00, 13 << 3];
  const parts = blocks.map((block, i) => {
    const header = Buffer.alloc(3);
    const isLast = i === blocks.length - 1 ? 1 : 0;
    header.writeUIntLE(isLast | (typeof block === 'string' ? 0 : 2) | (sizes[i] << 3), 0, 3);
    return Buffer.concat([header, typeof block === 'string' ? Buffer.from(block) : Buffer.from([block.byte])]);
  });
  return Buffer.concat([Buffer.from(head), ...parts]);
}

const block = fc.oneof(
  fc.string({ maxLength: 40 }),
  fc.record({ byte: fc.integer({ min: 32, max: 126 }), times: fc.integer({ min: 1, max: 1000 }) }),
);
const frame = fc.oneof(
  fc.tuple(fc.array(block, { minLength: 1, maxLength: 5 }), fc.boolean()).map(([blocks, isSingle]) => frameOf(blocks, isSingle)),
  // one that readers skip
  fc.uint8Array({ maxLength: 40 }).map((bytes) => Buffer.from([0x5a, 0x2a, 0x4d, 0x18, bytes.length, 0, 0, 0, ...bytes])),
);

describe('a frame of zstd', () => {
  it('ends where it ends, whatever follows and however it comes', () => {
    fc.assert(
      fc.property(frame, fc.uint8Array({ maxLength: 30 }), fc.array(fc.nat(), { maxLength: 6 }), (bytes, after, cuts) => {
        const all = Buffer.concat([bytes, after]);
        const places = [...cuts.map((at) => at % (all.length + 1)), 0, all.length].sort((a, b) => a - b);
        const one = new ZstdFrame();
        let taken = 0;
        for (let i = 1; i < places.length; i++) {
          if (places[i] <= bytes.length - 1) expect(one.isWhole).toBe(false);
          taken += one.take(all.subarray(places[i - 1], places[i]));
        }
        expect(one.isWhole).toBe(true);
        expect(taken).toBe(bytes.length);
      }),
    );
  });

  it('is not whole when it is cut', () => {
    fc.assert(
      fc.property(frame, fc.nat(), (bytes, end) => {
        const one = new ZstdFrame();
        one.take(bytes.subarray(0, end % bytes.length));
        expect(one.isWhole).toBe(false);
      }),
    );
  });

  it('packs of several are read to their end, and none that is cut, or Node has no zstd and they are refused', async () => {
    const line = frameOf([`${fallThrough()}\n`, { byte: 10, times: 20 }], true);
    const skipped = Buffer.from([0x50, 0x2a, 0x4d, 0x18, 2, 0, 0, 0, 7, 7]);
    const packed = Buffer.concat([line, skipped, line, line]);
    // Node has it from 22.15 on
    if (!('createZstdDecompress' in zlib)) {
      await expect(countLevels('z.ndjson.zst', packed)).rejects.toThrow('expected Node 22.15 or newer, or a pack as .gz');
      return;
    }
    expect(await countLevels('z.ndjson.zst', packed)).toBe(3);
    expect(readEntry(join(place.directory, 'z.ndjson.zst'), '43').length).toBeGreaterThan(100);
    await fc.assert(
      fc.asyncProperty(fc.integer({ min: 1, max: packed.length - 1 }), async (end) => {
        const lengths = [line.length, line.length + skipped.length, packed.length - line.length];
        fc.pre(!lengths.includes(end));
        await expect(countLevels('z.ndjson.zst', packed.subarray(0, end))).rejects.toThrow('it may be cut off');
        expect(() => readEntry(join(place.directory, 'z.ndjson.zst'), '1')).toThrow('it may be cut off');
      }),
      { numRuns: 50 },
    );
  });
});
