import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { reasonAgainst } from '../.ci/before-publish.mjs';

const root = dirname(import.meta.dirname);
const manifest = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));

/** The targets of links and pictures in a Markdown text, without those of other hosts and without anchors. */
const relativeLinks = (text: string): string[] =>
  [...text.replace(/^```.*?^```/gms, '').matchAll(/\]\(([^)\s]+)\)/g)]
    .map(([, target]) => target.replace(/#.*$/, ''))
    .filter((target) => target !== '' && !/^[a-z]+:/i.test(target));

// npm is a script of cmd.exe there
describe.runIf(process.platform !== 'win32')('the package', () => {
  let folder: string;
  const packed = () => join(folder, 'package');
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'gq-package-'));
    execFileSync('npm', ['pack', '--ignore-scripts', '--pack-destination', folder], { cwd: root, stdio: 'ignore' });
    execFileSync('tar', ['-xzf', `${manifest.name}-${manifest.version}.tgz`], { cwd: folder });
  });
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  it('contains everything to which its README links', () => {
    const links = relativeLinks(readFileSync(join(packed(), 'README.md'), 'utf8'));
    expect(links.length).toBeGreaterThan(10);
    expect(links.filter((link) => !existsSync(join(packed(), link)))).toEqual([]);
  });

  it('contains no source map, since it does not contain the sources', () => {
    const files = execFileSync('tar', ['-tzf', `${manifest.name}-${manifest.version}.tgz`], { cwd: folder, encoding: 'utf8' });
    expect(files).toContain('package/dist/cli/main.js\n');
    expect(files.split('\n').filter((file) => /\.map$|\.ts$/.test(file) && !file.endsWith('.d.ts'))).toEqual([]);
  });

  it('has the command under its own name as well, which nobody else can have where the package is not installed', () => {
    expect(Object.keys(manifest.bin)).toEqual(['gq', manifest.name]);
    for (const file of Object.values<string>(manifest.bin)) expect(existsSync(join(packed(), file))).toBe(true);
  });
});

describe('publishing', () => {
  it('is refused without the address of the repository', () => {
    expect(reasonAgainst({})).toMatch(/no "repository"/);
    expect(reasonAgainst({ repository: { type: 'git' } })).toMatch(/no "repository"/);
    expect(reasonAgainst({ repository: { type: 'git', url: 'git+https://example.org/a.git' } })).toBeNull();
    expect(reasonAgainst({ repository: 'github:a/b' })).toBeNull();
    const ended = spawnSync(process.execPath, [join(root, '.ci/before-publish.mjs')], { encoding: 'utf8' });
    expect(ended.status).toBe(reasonAgainst(manifest) === null ? 0 : 1);
  });
});
