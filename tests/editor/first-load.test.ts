import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { FACTORIES } from '../../editor/phaser-parts.mjs';
import { BUILT_PAGE, firstFiles } from './first-files.ts';

/** What a browser may load before `gq edit` shows a level, gzipped bytes. bench/README.md says it, too. */
const LIMIT = 498_500;

const EDITOR = fileURLToPath(new URL('../../editor', import.meta.url));

describe('the first load of the page', () => {
  it('weighs at most so much, gzipped', () => {
    const sizes = [...firstFiles()].map(([path, content]) => [path, gzipSync(content, { level: 9 }).length] as const);
    const sum = sizes.reduce((total, [, size]) => total + size, 0);
    console.log([...sizes.map(([path, size]) => `${size} ${path}`), `${sum} of ${LIMIT}`].join('\n'));
    expect(sum).toBeLessThanOrEqual(LIMIT);
    // a limit that is far away finds nothing
    expect(sum).toBeGreaterThan(0.95 * LIMIT);
  });

  it('takes nothing from a file that takes something from it: that one would run first, and find nothing', () => {
    const scripts = [...firstFiles()].filter(([path]) => path.endsWith('.js'));
    const takes = new Map(
      scripts.map(([path, content]) => [
        path,
        [...content.toString().matchAll(/\bfrom\s*"\.\/([\w.-]+)"/g)].map(([, name]) => `assets/${name}`),
      ]),
    );
    const circles = [...takes].filter(([path, names]) => names.some((name) => takes.get(name)?.includes(path)));
    expect(circles.map(([path]) => path)).toEqual([]);
    expect(takes.size).toBeGreaterThan(1);
  });

  it('has the style of all of the page: what comes later changes the look of nothing', () => {
    const styles = readdirSync(join(BUILT_PAGE, 'assets')).filter((name) => name.endsWith('.css'));
    expect([...firstFiles().keys()].filter((path) => path.endsWith('.css'))).toEqual(styles.map((name) => `assets/${name}`));
  });
});

describe('Phaser in the page', () => {
  it('is of the version that package.json names', () => {
    const { version } = createRequire(import.meta.url)('phaser/package.json') as { version: string };
    const scripts = [...firstFiles()].filter(([path]) => path.endsWith('.js')).map(([, content]) => content.toString());
    expect(scripts.filter((text) => text.includes(`VERSION:\`${version}\``))).toHaveLength(1);
  });

  it('makes what the canvas draws with, and nothing else', () => {
    const texts = readdirSync(EDITOR, { recursive: true, encoding: 'utf8' })
      .filter((path) => /\.tsx?$/.test(path))
      .map((path) => readFileSync(join(EDITOR, path), 'utf8'))
      .filter((text) => / from 'phaser'/.test(text));
    const made = texts.flatMap((text) => [...text.matchAll(/\b(?:scene|this)\s*\.add\s*\.(\w+)\(/g)].map(([, name]) => name));
    expect([...new Set(made)].filter((name) => name !== 'existing').sort()).toEqual(Object.keys(FACTORIES).sort());
  });
});
