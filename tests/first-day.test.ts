import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { resolveConfig } from 'vite';
import { expect, it } from 'vitest';
import { parse as parseYaml } from 'yaml';
import { compile, simulate } from '../engine/index.ts';
import { RULES, readLevel } from '../schema/index.ts';
import { PROJECT } from './docs/page.ts';

// The first day of a contributor: scripts, versions, templates, and the change that CONTRIBUTING.md proposes.

const read = (path: string): string => readFileSync(join(PROJECT, path), 'utf8');
const manifest = JSON.parse(read('package.json'));
const contributing = read('CONTRIBUTING.md');

it('CONTRIBUTING.md names every npm script once, and no other', () => {
  const rows = [...contributing.matchAll(/^\| [^|]+ \| `npm (?:run )?([\w:.]+)`/gm)].map(([, script]) => script);
  const scripts = Object.keys(manifest.scripts).filter((script) => !['prepare', 'prepack', 'prepublishOnly'].includes(script));
  expect(rows.sort()).toEqual(scripts.sort());
});

it('the change that CONTRIBUTING.md proposes breaks the stated number of levels', () => {
  const from = /pulls with (\d+) px\/s2, the default of `pull`/.exec(contributing)?.[1];
  const to = /Make it (\d+)\./.exec(contributing)?.[1];
  expect(RULES.pull.default).toBe(Number(from));
  expect(read('schema/basics/default-rules.ts')).toContain(`pull: ${from},`);
  const names = readdirSync(join(PROJECT, 'levels')).filter((name) => name.endsWith('.level.json'));
  const broken = names.filter((name) => {
    const level = readLevel(readFileSync(join(PROJECT, 'levels', name)));
    if (!level.ok) throw new Error(`${name} is not valid`);
    const rules = { pull: Number(to), ...level.level.rules };
    const scene = compile({ ...level.level, rules }, 'precise');
    return !level.level.runs.some(({ holds }) => simulate(scene, holds).outcome === 'completed');
  });
  expect(contributing).toContain(`${broken.length} of the ${names.length} shipped levels are broken`);
});

it('the versions of Node agree', () => {
  const [, least, major] = /^>=((\d+)\.\d+)$/.exec(manifest.engines.node) ?? [];
  expect(read('README.md')).toContain(`Node ${least} or newer`);
  expect(read('.nvmrc')).toBe(`${major}\n`);
  expect(JSON.parse(read('.devcontainer/devcontainer.json')).image).toMatch(new RegExp(`:${major}-`));
  expect(manifest.devDependencies['@types/node']).toMatch(new RegExp(`^\\^${least}\\.`));
});

it('the page is built for the browsers that docs/editor.md promises', async () => {
  const { build } = await resolveConfig({ configFile: join(PROJECT, 'editor/vite.config.ts'), logLevel: 'silent' }, 'build');
  const promised = /Chrome or Edge (\S+), Firefox (\S+), Safari (\S+), or newer/.exec(read('docs/editor.md'))?.slice(1);
  expect(build.target).toEqual(['chrome', 'firefox', 'safari'].map((name, i) => `${name}${promised?.[i]}`));
});

it('GitHub can read the templates for issues', () => {
  const folder = '.github/ISSUE_TEMPLATE';
  const templates = readdirSync(join(PROJECT, folder)).filter((name) => name !== 'config.yml');
  expect(templates.length).toBeGreaterThan(2);
  for (const name of templates) {
    const { name: title, description, body } = parseYaml(read(`${folder}/${name}`));
    expect(
      [title, description].every((text) => typeof text === 'string' && text !== ''),
      name,
    ).toBe(true);
    const ids = body.map(({ id }: { id: string }) => id);
    expect(new Set(ids).size, name).toBe(ids.length);
    for (const { type, attributes } of body) {
      expect(['markdown', 'textarea', 'input', 'dropdown', 'checkboxes'], name).toContain(type);
      expect(attributes.label, name).toMatch(/\S/);
    }
  }
  expect(existsSync(join(PROJECT, '.github/PULL_REQUEST_TEMPLATE.md'))).toBe(true);
});
