import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';

const root = join(import.meta.dirname, '..');
const SITE = join(root, 'dist', 'site');

/** bytes, compressed, of everything that the page loads, Phaser included */
const MOST_BYTES = 600_000;

const read = (name: string): string => readFileSync(join(SITE, name), 'utf8');

describe('the built example', () => {
  it('consists of a page, the game and the pack', () => {
    expect(readdirSync(SITE).sort()).toEqual(['game.js', 'index.html', 'pack.js']);
  });

  it('is small enough', () => {
    const sizes = readdirSync(SITE).map((name) => gzipSync(readFileSync(join(SITE, name))).length);
    const sum = sizes.reduce((all, size) => all + size, 0);
    // less would mean that Phaser is missing
    expect(sum).toBeGreaterThan(300_000);
    expect(sum).toBeLessThan(MOST_BYTES);
  });

  it('loads classic scripts beside it, so that it opens from a file', () => {
    const scripts = [...read('index.html').matchAll(/<script\b[^>]*>/g)].map(([tag]) => tag);
    expect(scripts).toHaveLength(2);
    for (const tag of scripts) expect(tag).toMatch(/^<script defer src="\.\/(pack|game)\.js"\s*>$/);
    expect(read('index.html')).not.toMatch(/<link\b[^>]*(stylesheet|modulepreload)|(src|href)="(\/|https?:)/);
    expect(() => new Function(read('game.js'))).not.toThrow();
    expect(read('game.js')).not.toMatch(/\bimport\(|import\.meta/);
  });

  it('has the shipped levels in its pack', () => {
    const scope: { GRAVITY_QUEST_PACK?: { levels: { id: string }[] } } = {};
    new Function('globalThis', read('pack.js'))(scope);
    const files = readdirSync(join(root, 'levels')).filter((name) => name.endsWith('.level.json'));
    expect(scope.GRAVITY_QUEST_PACK?.levels.map(({ id }) => `${id}.level.json`)).toEqual(files.sort());
  });
});
