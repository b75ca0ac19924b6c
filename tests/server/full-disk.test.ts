import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { LevelFolder } from '../../cli/serve/level-folder.ts';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { Refusal } from '../../cli/serve/refusal.ts';
import { gqEdit } from './command.ts';
import { everythingIn, levelPath, levelText, makeFolder, pageOf } from './running.ts';

// A disk may fail at every step. Whatever the step, either the change is refused and nothing has changed, or it is done.

const disk = vi.hoisted(() => ({ failAt: -1, code: '', steps: 0, failed: '' }));

vi.mock('node:fs', async (original) => {
  const fs = await original<typeof import('node:fs')>();
  type Step = 'openSync' | 'writeFileSync' | 'writeSync' | 'fsyncSync' | 'linkSync' | 'renameSync' | 'mkdirSync' | 'rmSync';
  const isChange = (name: Step, args: unknown[]): boolean => {
    if (name === 'openSync') return args[1] === 'wx';
    // a failing cleanup may leave something behind, and nothing else
    return name !== 'rmSync' || String(args[0]).endsWith('.level.json');
  };
  const failing = (name: Step) => {
    const real = fs[name] as (...args: unknown[]) => unknown;
    return (...args: unknown[]): unknown => {
      if (isChange(name, args) && disk.steps++ === disk.failAt) {
        disk.failed = name;
        // a full disk takes the first part
        if (name === 'writeFileSync') real(args[0], (args[1] as Buffer).subarray(0, 10));
        throw Object.assign(new Error(`${disk.code}: ${name}`), { code: disk.code });
      }
      return real(...args);
    };
  };
  const names: Step[] = ['openSync', 'writeFileSync', 'writeSync', 'fsyncSync', 'linkSync', 'renameSync', 'mkdirSync', 'rmSync'];
  return { ...fs, ...Object.fromEntries(names.map((name) => [name, failing(name)])) };
});

let made: ReturnType<typeof makeFolder>;
beforeEach(() => {
  disk.failAt = -1;
  made = makeFolder({ '01.level.json': levelText('A'), '02.level.json': levelText('B'), '03.level.json': levelText('C') });
});
afterEach(() => made.remove());

/** Everything except the folders of the trash. */
const levelsIn = (folder: string): Record<string, string> =>
  Object.fromEntries(
    Object.entries(everythingIn(folder)).filter(([name, content]) => content !== 'folder' && !name.endsWith('.gitignore')),
  );

const client = 'page';
const changes: [name: string, change: (levels: LevelFolder, etag: (id: string) => string) => Promise<unknown>][] = [
  ['overwriting', (levels, etag) => levels.write('01', levelText('new'), { etag: etag('01') }, client)],
  ['a new level', (levels) => levels.write('04', levelText('new'), 'no-file', client)],
  ['renaming', (levels, etag) => levels.rename('01', 'new', etag('01'), client)],
  ['copying', (levels, etag) => levels.duplicate('01', 'new', etag('01'), client)],
  ['deleting', (levels, etag) => levels.remove('01', etag('01'), client)],
  ['ordering in a ring', (levels) => levels.order('', ['03', '01', '02'], client)],
];

describe.each(['ENOSPC', 'EDQUOT', 'EROFS', 'EACCES', 'EIO', 'EPERM'])('%s', (code) => {
  it.each(changes)('at any step of %s', async (_, change) => {
    const steps: string[] = [];
    for (let failAt = 0; ; failAt++) {
      made.remove();
      made = makeFolder({ '01.level.json': levelText('A'), '02.level.json': levelText('B'), '03.level.json': levelText('C') });
      const levels = openLevelFolder(made.folder, 'levels');
      const before = levelsIn(made.folder);
      Object.assign(disk, { failAt, code, steps: 0, failed: '' });
      const refused = await change(levels, (id) => levels.read(id).etag ?? '').then(
        () => null,
        (error: unknown) => error,
      );
      disk.failAt = -1;
      const after = levelsIn(made.folder);
      if (refused !== null) {
        expect(refused).toBeInstanceOf(Refusal);
        const { code: said, message, hint } = refused as Refusal;
        expect(said).toBe({ ENOSPC: 'disk-full', EDQUOT: 'disk-full', EIO: 'failed' }[code] ?? 'not-writable');
        expect(message).toContain('levels');
        expect(hint).toMatch(/\./);
        expect(after).toEqual(before);
      } else {
        expect(after).not.toEqual(before);
        expect(Object.keys(after).filter((name) => name.includes('tmp') || name.includes('lock'))).toEqual([]);
      }
      // the next change succeeds
      const next = await levels.write('02', levelText('next'), { etag: levels.read('02').etag ?? '' }, client);
      expect(next.entry.name).toBe('next');
      if (disk.failed === '') break;
      steps.push(disk.failed);
    }
    expect(steps.length).toBeGreaterThan(3);
  });
});

it.runIf(process.platform !== 'win32')(
  'the old text stays if the disk has room for only a part of the new one, and smaller texts can be saved',
  async () => {
    // the kernel's limit for file sizes, KiB: it writes what fits and refuses the rest, like a full disk
    const server = await gqEdit(['.', '--port', '0'], { cwd: made.folder, maxFileSize: 8 });
    const page = pageOf(server);
    const { etag } = (await page.get(levelPath('01'))).json() as { etag: string };
    const large = JSON.stringify({ ...JSON.parse(levelText('large')), 'x-note': 'x'.repeat(20_000) });
    const answer = await page.send('PUT', levelPath('01'), { text: large, client }, { 'If-Match': etag });
    expect(answer.status).toBe(507);
    expect(answer.json()).toMatchObject({ error: { code: 'disk-full', hint: expect.stringContaining('Make room') } });
    expect(readFileSync(join(made.folder, '01.level.json'), 'utf8')).toBe(levelText('A'));
    expect(readdirSync(made.folder).sort()).toEqual(['01.level.json', '02.level.json', '03.level.json']);
    expect((await page.send('PUT', levelPath('01'), { text: levelText('small'), client }, { 'If-Match': etag })).status).toBe(
      200,
    );
    await server.end('SIGTERM');
  },
);
