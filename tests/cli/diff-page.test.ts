import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Script } from 'node:vm';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type LevelFile, listOf } from '../../schema/index.ts';
import { gq, makeFiles } from './gq.ts';
import { shipped } from './levels.ts';

const before = JSON.parse(readFileSync(shipped('18-grand-tour'), 'utf8')) as LevelFile;
const HOSTILE = '</script><script>alert(1)</script><img src=x onerror=alert(1)>"\'&\u0000';
const after = structuredClone(before);
after.name = HOSTILE.slice(0, 119).replace('\u0000', '');
after.runs![0].name = '</script>"><svg onload=alert(1)>';
after.runs![0].holds[1][1] += 2;
after.asteroids![0].y += 40;
after[listOf('nova')]!.splice(0, 1);
after.minerals!.push({ x: 200, y: 200 });

describe('pictures of a diff', () => {
  let files: ReturnType<typeof makeFiles>;
  let page: string;
  const diff = (...args: string[]) => gq(['diff', '--no-slack', ...args], { cwd: files.directory });
  beforeAll(async () => {
    files = makeFiles({
      'a.level.json': JSON.stringify(before),
      'b <i>.level.json': JSON.stringify(after),
      'invalid.level.json': '{}',
      'old/a.level.json': JSON.stringify(before),
      'old/b.level.json': JSON.stringify({ ...before, name: 'B' }),
      'new/a.level.json': JSON.stringify(after),
      'new/c.level.json': readFileSync(shipped('16-firewalk')),
    });
    page = (await diff('--format', 'html', 'a.level.json', 'b <i>.level.json')).stdout;
  });
  afterAll(() => files.remove());

  it('contains hostile names as text only', () => {
    expect(page).not.toMatch(/<img src=x|<script>alert|<svg onload|<i>/);
    expect(page.match(/<script/g)).toHaveLength(2);
    expect(page).toContain('&lt;/script&gt;&lt;script&gt;alert(1)');
  });

  it('allows its own script and style only, and needs nothing else', () => {
    const policy = /Content-Security-Policy" content="([^"]*)"/.exec(page)?.[1].replaceAll('&#39;', "'") ?? '';
    const hash = (text: string): string => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
    const script = /<script>([\s\S]*?)<\/script>/.exec(page)?.[1] ?? '';
    const style = /<style>([\s\S]*?)<\/style>/.exec(page)?.[1] ?? '';
    expect(policy).toContain("default-src 'none'");
    expect(policy).toContain(`script-src ${hash(script)};`);
    expect(policy).toContain(`style-src ${hash(style)};`);
    expect(new Script(script)).toBeDefined();
    // a policy by hashes refuses attributes
    expect(page).not.toMatch(/<[^>]+ (?:style|on\w+)=/);
    const addresses = [...page.matchAll(/(?:src|srcset|href)="([^"]*)"/g)].map(([, address]) => address);
    expect(addresses.length).toBeGreaterThan(5);
    expect(addresses.filter((address) => !/^(?:#|data:image\/svg\+xml;base64,)/.test(address))).toEqual([]);
  });

  it('has both runs, tick by tick, and the moved edges', () => {
    const data = JSON.parse(/id="runs">([\s\S]*?)<\/script>/.exec(page)?.[1] ?? '');
    const [old, now] = data[0].runs;
    expect([old.when, now.when]).toEqual(['before', 'after']);
    for (const { at } of [old, now]) expect(at.every((value: unknown) => Number.isFinite(value))).toBe(true);
    expect(data[0].ticks).toBe(Math.max(old.at.length, now.at.length) / 3 - 1);
    expect(page).toContain('release 2: tick 810 → 812');
    const own = page.replace(/<script>[\s\S]*?<\/script>/, '').replace(/base64,[^"]*/g, '');
    expect(own).not.toMatch(/NaN|undefined|Infinity/);
  });

  it('marks in SVG what was added, removed and moved', async () => {
    const { stdout, code } = await diff('--format', 'svg', '--theme', 'light', 'a.level.json', 'b <i>.level.json');
    expect(code).toBe(0);
    for (const kind of ['added', 'removed', 'changed', 'arrow', 'ghost']) expect(stdout).toContain(`data-kind="${kind}"`);
    expect(stdout).not.toMatch(/NaN|undefined|Infinity|<script|onload=a[^l]/);
    expect(stdout.match(/data-kind="timeline"/g)).toHaveLength(2);
    // the same input gives the same bytes
    expect((await diff('--format', 'svg', '--theme', 'light', 'a.level.json', 'b <i>.level.json')).stdout).toBe(stdout);
  });

  it('draws levels of one side alone, and says what it cannot draw', async () => {
    const folders = (await diff('--format', 'html', 'old', 'new')).stdout;
    expect(folders.match(/<section /g)).toHaveLength(3);
    expect(folders).toContain('<nav aria-label="Levels">');
    expect((await diff('--format', 'svg', 'a.level.json', '/dev/null')).stdout).toContain('removed');
    expect(await diff('--format', 'svg', 'old', 'new')).toMatchObject({
      code: 2,
      stderr: expect.stringContaining('draws one level, and 3 levels changed'),
    });
    expect(await diff('--format', 'svg', 'invalid.level.json', '/dev/null')).toMatchObject({ code: 2, stdout: '' });
    const file = join(files.directory, 'out.html');
    expect(await diff('--format', 'html', '-o', 'out.html', 'a.level.json', 'invalid.level.json')).toMatchObject({
      code: 0,
      stdout: '',
      stderr: 'wrote out.html\n',
    });
    expect(readFileSync(file, 'utf8')).toContain('invalid');
    expect((await diff('--format', 'html', 'a.level.json', 'a.level.json')).stdout).toContain('No level changed.');
  });
});
