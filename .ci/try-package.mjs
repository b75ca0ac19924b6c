import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { createServer } from 'node:http';
import { availableParallelism, tmpdir } from 'node:os';
import { basename, dirname, extname, join, resolve } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { build as bundle, transform } from 'esbuild';
import { chromium } from 'playwright-core';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { createServer as createVite, build as viteBuild } from 'vite';
import { ENGINE_ENTRIES, ENGINE_NAME, packEngine } from './pack-engine.mjs';

// node .ci/try-package.mjs
// Packs the toolkit and the engine alone, lints the tarballs, installs them as users do, and uses every public entry from every
// kind of project that is supported. Each use must give what the sources give. Names the project, the entry, what was expected
// and what was found. Needs a build, Chromium and the registry.

const PROJECT = resolve(import.meta.dirname, '..');
const TRIALS = join(PROJECT, '.ci/try-package');
const manifest = JSON.parse(readFileSync(join(PROJECT, 'package.json'), 'utf8'));

/** Versions of TypeScript that are supported, by the name under which they are installed here. */
const TYPESCRIPTS = { ts50: '5.0', ts54: '5.4', ts59: '5.9', ts60: '6.0', ts70: '7.0' };

/** The level that the programs with Phaser in docs/library.md play. */
const PROGRAM = 'levels/12-detour.level.json';

/** Versions that are tried with `node16`; all others with `nodenext`. */
const OLD_TYPESCRIPTS = ['ts50', 'ts54'];

/** Entries whose declarations need those of Phaser, which take long to read: older versions read them once. */
const PHASER = /^\.\/phaser/;

/** Errors in declarations of others, which are theirs: those who use these packages need skipLibCheck for them. */
const KNOWN = [
  // Phaser 4's own declarations contradict themselves, for every version of TypeScript
  /^\S*\/phaser\/types\/phaser\.d\.ts\(/,
  // zod, which the entries schema and solver show, uses a type of TypeScript 5.4
  /^\S*\/zod\/v4\/.*Cannot find name 'NoInfer'/,
];

/** Shipped levels that the uses read. */
const LEVELS = { solver: 'levels/01-first-pull.level.json' };
const USUAL_LEVEL = 'levels/16-firewalk.level.json';

const ATTW = join(dirname(fileURLToPath(import.meta.resolve('@arethetypeswrong/cli/package.json'))), 'dist/index.js');

/** What the most that an installation may bring is, MB. The engine alone is for those who want no more. */
const MOST = { [manifest.name]: 30, [ENGINE_NAME]: 2.5 };

// --- the parts

/** The file in TRIALS that tries an entry: engine for ".", phaser-plugin for "./phaser/plugin". */
const trialOf = (entry) => (entry === '.' ? 'engine' : entry.slice(2).replaceAll('/', '-'));

const isJson = (entry) => entry.endsWith('.json');
const MODULES = Object.keys(manifest.exports).filter((entry) => manifest.exports[entry].types !== undefined);

/** Entries that are neither modules nor JSON: scripts for a tag of a page, which tests of the browser run. */
const SCRIPTS = Object.keys(manifest.exports).filter((entry) => !isJson(entry) && !MODULES.includes(entry));
/** The files of the entries that are JSON; a pattern stands for all its files. */
const JSON_FILES = Object.fromEntries(
  Object.entries(manifest.exports)
    .filter(([entry]) => isJson(entry))
    .flatMap(([entry, path]) => {
      const [before, after] = entry.split('*');
      if (after === undefined) return [[entry, path]];
      const names = readdirSync(join(PROJECT, path.split('*')[0])).filter((name) => name.endsWith(after));
      return names.map((name) => [`${before}${name}`, `${path.split('*')[0]}${name}`]);
    }),
);
const JSONS = Object.keys(JSON_FILES);

const failures = [];
const fail = (project, entry, message) => failures.push(`${project}: ${entry}: ${message}`);

/** Runs a program; what it prints and its exit code. */
function run(program, args, options = {}) {
  return new Promise((done) => {
    const child = spawn(program, args, { stdio: ['ignore', 'pipe', 'pipe'], ...options });
    let stdout = '';
    let stderr = '';
    child.stdout.on('data', (data) => (stdout += data));
    child.stderr.on('data', (data) => (stderr += data));
    child.on('error', (error) => done({ code: -1, stdout, stderr: `${stderr}${error.message}` }));
    child.on('close', (code) => done({ code, stdout, stderr }));
  });
}

/** Runs jobs, as many at a time as there are processors. */
async function each(jobs) {
  const open = [...jobs];
  const worker = async () => {
    for (let job = open.shift(); job !== undefined; job = open.shift()) await job();
  };
  await Promise.all(Array.from({ length: Math.max(2, availableParallelism()) }, worker));
}

const lastLines = ({ stdout, stderr }) => `${stdout}\n${stderr}`.trim().split('\n').slice(-12).join('\n    ');

function write(path, content) {
  mkdirSync(join(path, '..'), { recursive: true });
  writeFileSync(path, content);
}

/** Compares what a project gave for each entry with what the sources give. */
function compare(project, found, entries = Object.keys(found)) {
  for (const entry of entries) {
    const wanted = expected[entry];
    if (found[entry] !== wanted)
      fail(project, entry, `expected ${wanted}, as the sources give; found ${found[entry] ?? 'nothing'}`);
  }
}

// --- what the sources give

const textOf = (use) => readFileSync(join(PROJECT, LEVELS[use] ?? USUAL_LEVEL), 'utf8');
const digest = (value) => createHash('sha256').update(JSON.stringify(value)).digest('hex').slice(0, 16);

async function expectations() {
  // the sources under the names of the package
  const alias = MODULES.map((entry) => ({
    find: new RegExp(`^${manifest.name}${entry.slice(1)}$`),
    replacement: join(PROJECT, manifest.exports[entry].default.replace(/^\.\/dist\//, '').replace(/\.js$/, '.ts')),
  }));
  const server = { middlewareMode: true, hmr: false, watch: null };
  const vite = await createVite({ configFile: false, logLevel: 'error', root: PROJECT, resolve: { alias }, server });
  const found = {};
  try {
    for (const entry of MODULES) {
      const { trial } = await vite.ssrLoadModule(join(TRIALS, `${trialOf(entry)}.ts`));
      found[entry] = trial(textOf(trialOf(entry)));
    }
    // the programs of the page play the run of one level
    const { createPlayer, readLevel } = await vite.ssrLoadModule(join(PROJECT, 'game/index.ts'));
    const { level } = readLevel(readFileSync(join(PROJECT, PROGRAM), 'utf8'));
    const player = createPlayer(level, { replay: level.runs[0].holds });
    while (player.ending === null) player.advance(16);
    found[PROGRAM] = `${player.ending.outcome} ${player.hash}`;
  } finally {
    await vite.close();
  }
  for (const [entry, path] of Object.entries(JSON_FILES))
    found[entry] = digest(JSON.parse(readFileSync(join(PROJECT, path), 'utf8')));
  return found;
}

// --- the projects

/** Uses of some entries of a package, in a project that has it installed. */
async function writeTrials(folder, name, entries) {
  for (const entry of entries) {
    const source = readFileSync(join(TRIALS, `${trialOf(entry)}.ts`), 'utf8').replaceAll(`'${manifest.name}`, `'${name}`);
    write(join(folder, 'src', `${trialOf(entry)}.ts`), source);
    write(join(folder, 'esm', `${trialOf(entry)}.js`), (await transform(source, { loader: 'ts' })).code);
    write(
      join(folder, 'cjs', `${trialOf(entry)}.js`),
      (await transform(source, { loader: 'ts', format: 'cjs', platform: 'node' })).code,
    );
  }
  write(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  write(join(folder, 'cjs/package.json'), '{ "type": "commonjs" }');
  write(
    join(folder, 'texts.json'),
    JSON.stringify(Object.fromEntries(entries.map((entry) => [trialOf(entry), textOf(trialOf(entry))]))),
  );
  const modules = JSON.stringify(entries.map((entry) => [entry, trialOf(entry)]));
  const jsons = JSON.stringify(name === manifest.name ? JSONS.map((entry) => [entry, `${name}${entry.slice(1)}`]) : []);
  const common = `
const digest = (value) => createHash('sha256').update(JSON.stringify(value)).digest('hex').slice(0, 16);
const texts = JSON.parse(readFileSync('${folder}/texts.json', 'utf8'));
const found = {};
const take = async (entry, get) => { try { found[entry] = await get(); } catch (error) { found[entry] = 'the error ' + error.message; } };
(async () => {
  for (const [entry, use] of ${modules}) await take(entry, async () => (await load(use)).trial(texts[use]));
  for (const [entry, name] of ${jsons}) await take(entry, async () => digest(await loadJson(name)));
  console.log(JSON.stringify(found));
})();
`;
  write(
    join(folder, 'run.js'),
    `import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { argv } from 'node:process';
const load = (use) => import(argv[2] + '/' + use + '.js');
const loadJson = async (name) => (await import(name, { with: { type: 'json' } })).default;
${common}`,
  );
  write(
    join(folder, 'run.cjs'),
    `const { createHash } = require('node:crypto');
const { readFileSync } = require('node:fs');
const load = (use) => require('./cjs/' + use + '.js');
const loadJson = require;
${common}`,
  );
}

/** Runs the uses in Node. */
async function inNode(project, folder, args, entries) {
  const ended = await run(process.execPath, args, { cwd: folder });
  if (ended.code !== 0) return fail(project, 'all entries', `expected exit code 0, found ${ended.code}\n    ${lastLines(ended)}`);
  // a warning would be seen by everybody who uses the package; that of JSON modules is about the import, which is the user's
  const warned = ended.stderr
    .split('\n')
    .filter((line) => /warning/i.test(line) && !/Import(?:ing)? (?:JSON|attributes|assertions)/i.test(line));
  if (warned.length > 0) fail(project, 'all entries', `expected no warning, found ${warned[0]}`);
  compare(project, JSON.parse(ended.stdout), entries);
}

/** Compiles the uses with a version of TypeScript, and runs what it writes. */
async function inTypeScript({ folder, tools, name, version, resolution, entries }) {
  const isNode = resolution !== 'bundler';
  const project = `TypeScript ${TYPESCRIPTS[version]}, moduleResolution ${resolution}, ${name}`;
  const id = `${version}-${resolution}`;
  const json = isNode || name !== manifest.name ? [] : ['json.ts'];
  const compilerOptions = {
    ...{
      strict: true,
      skipLibCheck: false,
      skipDefaultLibCheck: true,
      target: 'es2022',
      lib: ['es2022', 'dom'],
      types: [],
      moduleResolution: resolution,
    },
    ...(isNode
      ? { module: resolution, rootDir: 'src', outDir: `out/${id}` }
      : { module: 'esnext', noEmit: true, resolveJsonModule: true }),
  };
  const files = [...entries.map((entry) => `${trialOf(entry)}.ts`), ...json].map((file) => `src/${file}`);
  write(join(folder, `tsconfig.${id}.json`), JSON.stringify({ compilerOptions, files }));
  const tsc = join(tools, 'node_modules', version, 'bin/tsc');
  const ended = await run(process.execPath, [tsc, '-p', `tsconfig.${id}.json`, '--pretty', 'false'], { cwd: folder });
  const errors = ended.stdout
    .split(/\n(?! )/)
    .filter((error) => error.includes(': error ') && !KNOWN.some((known) => known.test(error)));
  if (errors.length > 0) {
    const [entry] = /src\/[\w-]+\.ts/.exec(errors[0]) ?? ['a declaration'];
    return fail(project, entry, `expected that it compiles, found\n    ${errors.slice(0, 4).join('\n    ')}`);
  }
  if (isNode) await inNode(project, folder, ['run.js', `./out/${id}`], entries);
}

/** The programs of docs/library.md that need a browser, by their names. */
function programsWithPhaser() {
  const blocks = readFileSync(join(PROJECT, 'docs/library.md'), 'utf8').matchAll(/^```ts title=(\S+)\n([\s\S]*?)^```$/gm);
  return [...blocks].filter(([, , code]) => code.includes("from 'phaser'")).map(([, name, code]) => ({ name, code }));
}

/** A page and a worker that use the entries, as sources of a bundler. */
function writePage(folder, entries) {
  const inWorker = entries.filter((entry) => !entry.startsWith('./phaser'));
  const program = (those) => `
${those.map((entry, i) => `import { trial as trial${i} } from './esm/${trialOf(entry)}.js';`).join('\n')}
import texts from './texts.json';
const uses = [${those.map((entry, i) => `['${entry}', '${trialOf(entry)}', trial${i}]`).join(', ')}];
const results = {};
for (const [entry, use, call] of uses) {
  try { results[entry] = call(texts[use]); } catch (error) { results[entry] = 'the error ' + error.message; }
}`;
  const jsons = JSONS.map((entry, i) => `import json${i} from '${manifest.name}${entry.slice(1)}';`).join('\n');
  const digests = `globalThis.jsons = { ${JSONS.map((entry, i) => `'${entry}': json${i}`).join(', ')} };`;
  write(join(folder, 'worker.js'), `${program(inWorker)}\npostMessage(results);\n`);
  write(join(folder, 'main.js'), `${jsons}\n${program(entries)}\n${digests}\nglobalThis.results = results;\n`);
  const wait =
    'worker.onmessage = ({ data }) => { globalThis.ofWorker = data; }; worker.onerror = ({ message }) => { globalThis.ofWorker = { worker: message }; };';
  write(
    join(folder, 'vite-main.js'),
    `import './main.js';\nconst worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });\n${wait}\n`,
  );
  write(join(folder, 'index.html'), '<!doctype html><title>vite</title><script type="module" src="./vite-main.js"></script>');
  write(
    join(folder, 'esbuild/index.html'),
    `<!doctype html><title>esbuild</title><script src="main.js"></script><script>const worker = new Worker('worker.js'); ${wait}</script>`,
  );
  return inWorker;
}

/** Bundles the programs of the page that need Phaser, each with a page of its own. */
async function writePrograms(folder, programs) {
  for (const { name, code } of programs) {
    const out = `site/${name}`;
    // a small canvas, since the processor draws it
    write(join(folder, 'programs', name), code.replace('width: 960, height: 640', 'width: 240, height: 160'));
    write(join(folder, out, 'index.html'), '<!doctype html><script type="module" src="program.js"></script>');
    cpSync(join(PROJECT, 'levels'), join(folder, out, 'levels'), { recursive: true });
    const common = { bundle: true, format: 'esm', target: 'es2022', logLevel: 'silent' };
    await bundle({ ...common, absWorkingDir: folder, entryPoints: [`programs/${name}`], outfile: `${out}/program.js` });
  }
}

/** Runs a program of the page until it has written a line: how the run of the level ended. */
async function inPhaser(browser, address, { name }) {
  const page = await browser.newPage();
  const project = `docs/library.md, ${name} with Phaser in Chromium`;
  page.on('pageerror', (error) => fail(project, './phaser', `expected no error, found ${error.message}`));
  const ended = page.waitForEvent('console', {
    predicate: (message) => /^[a-z]+ [0-9a-f]{16}$/.test(message.text()),
    timeout: 150_000,
  });
  const said = ended.then((message) => message.text()).catch(() => 'nothing in 150 s');
  await page.goto(`${address}/${name}/index.html`);
  compare(project, { [PROGRAM]: await said });
  await page.close();
}

const TYPES_OF_FILES = { '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.css': 'text/css' };

/** Uses the entries on pages that Vite and esbuild have made, and in a worker of each. */
async function inBrowser(folder, entries) {
  const inWorker = writePage(folder, entries);
  const tried = await Promise.allSettled([
    viteBuild({
      root: folder,
      configFile: false,
      logLevel: 'error',
      worker: { format: 'es' },
      build: { outDir: 'site/vite', assetsInlineLimit: 0 },
      base: './',
    }),
    bundle({
      absWorkingDir: folder,
      entryPoints: ['main.js', 'worker.js'],
      outdir: 'site/esbuild',
      bundle: true,
      minify: true,
      format: 'iife',
      logLevel: 'silent',
    }),
  ]);
  const made = ['Vite', 'esbuild'].filter((name, i) => {
    if (tried[i].status === 'rejected')
      fail(name, 'all entries', `expected that it builds, found\n    ${tried[i].reason.message}`);
    return tried[i].status === 'fulfilled';
  });
  if (made.includes('esbuild')) cpSync(join(folder, 'esbuild'), join(folder, 'site/esbuild'), { recursive: true });
  const server = createServer(({ url }, response) => {
    const path = join(folder, 'site', new URL(url, 'http://localhost').pathname);
    if (!existsSync(path) || extname(path) === '') return response.writeHead(404).end();
    response
      .writeHead(200, { 'content-type': TYPES_OF_FILES[extname(path)] ?? 'application/octet-stream' })
      .end(readFileSync(path));
  });
  const programs = programsWithPhaser();
  if (programs.length === 0) fail('docs/library.md', './phaser', 'expected a program with Phaser, found none');
  await writePrograms(folder, programs);
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  const address = `http://127.0.0.1:${server.address().port}`;
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu'],
  });
  try {
    const played = Promise.all(programs.map((program) => inPhaser(browser, address, program)));
    for (const name of made) {
      const page = await browser.newPage();
      const errors = [];
      page.on('pageerror', (error) => errors.push(error.message));
      await page.goto(`${address}/${name.toLowerCase()}/index.html`);
      await page.waitForFunction(() => globalThis.results && globalThis.ofWorker, null, { timeout: 20_000 }).catch(() => {});
      const [results, ofWorker, jsons] = await page.evaluate(() => [globalThis.results, globalThis.ofWorker, globalThis.jsons]);
      for (const error of errors) fail(`${name}, production build in Chromium`, 'the page', `expected no error, found ${error}`);
      compare(`${name}, production build in Chromium`, results ?? {}, entries);
      compare(`${name}, Web Worker in Chromium`, ofWorker ?? {}, inWorker);
      compare(`${name}, production build in Chromium`, Object.fromEntries(JSONS.map((entry) => [entry, digest(jsons?.[entry])])));
    }
    await played;
  } finally {
    await browser.close();
    server.close();
  }
}

// --- the tarballs

async function lint(tarball) {
  const { messages } = await publint({ pack: { tarball: Uint8Array.from(readFileSync(tarball)).buffer }, strict: true });
  const packed = JSON.parse((await run('tar', ['-xzOf', tarball, 'package/package.json'])).stdout);
  for (const message of messages)
    fail('publint', basename(tarball), `expected no remark, found ${formatMessage(message, packed)}`);
  // The profile leaves out two things, on purpose. `require` of these modules gives ES modules: Node does so from 20.19 on, which
  // is the oldest that is supported, and the projects below try it; a second build as CommonJS would double the package, and
  // a program that loads both builds would have two engines. TypeScript's old resolution `node10` does not know `exports`.
  const attw = await run(process.execPath, [
    ATTW,
    tarball,
    // scripts for a tag of a page have no types
    ...SCRIPTS.flatMap((entry) => ['--exclude-entrypoints', entry]),
    '--profile',
    'esm-only',
    '--no-color',
    '--no-emoji',
    '--format',
    'ascii',
  ]);
  if (attw.code !== 0) fail('attw', basename(tarball), `expected no problem, found\n    ${lastLines(attw)}`);
}

/** Size of the files of a folder, bytes. */
function sizeOf(folder) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  return files.reduce((sum, file) => sum + readFileSync(join(file.parentPath, file.name)).length, 0);
}

/** Installed packages, the largest first. */
function installed(folder) {
  const modules = join(folder, 'node_modules');
  const names = readdirSync(modules).flatMap((name) => {
    if (name.startsWith('.')) return [];
    return name.startsWith('@') ? readdirSync(join(modules, name)).map((inner) => `${name}/${inner}`) : [name];
  });
  return names.map((name) => ({ name, size: sizeOf(join(modules, name)) })).sort((a, b) => b.size - a.size);
}

const megabytes = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;

/** Installs packages into a new project. */
async function install(folder, packages) {
  mkdirSync(folder, { recursive: true });
  if (!existsSync(join(folder, 'package.json'))) write(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  const args = ['install', '--silent', '--no-audit', '--no-fund', '--prefer-offline', '--ignore-scripts', ...packages];
  const ended = await run('npm', args, { cwd: folder });
  if (ended.code !== 0) throw new Error(`npm install ${packages.join(' ')}\n${lastLines(ended)}`);
}

function report(name, folder) {
  const list = installed(folder);
  const total = list.reduce((sum, { size }) => sum + size, 0);
  console.log(
    `${name}: ${megabytes(total)} in ${list.length} packages: ${list
      .filter(({ size }) => size > 5e4)
      .map((p) => `${p.name} ${megabytes(p.size)}`)
      .join(', ')}`,
  );
  if (total > MOST[name] * 1e6) fail(name, 'installed', `expected at most ${MOST[name]} MB, found ${megabytes(total)}`);
  return new Set(list.map((p) => p.name));
}

// --- the command

/** Runs `gq` in a project. */
const gq = (folder, ...args) => run('npx', ['--no-install', 'gq', ...args], { cwd: folder });

async function tryCommand(project, folder, hasPng) {
  cpSync(join(PROJECT, 'levels'), join(folder, 'levels'), { recursive: true });
  const checked = await gq(folder, 'check', 'levels', '--format', 'json');
  const levels = checked.code === 0 ? JSON.parse(checked.stdout).levels.length : 0;
  const shipped = readdirSync(join(PROJECT, 'levels')).filter((name) => name.endsWith('.level.json')).length;
  if (levels !== shipped)
    fail(
      project,
      'gq check',
      `expected ${shipped} levels and exit code 0, found ${levels} and ${checked.code}\n    ${lastLines(checked)}`,
    );
  const svg = await gq(folder, 'render', USUAL_LEVEL, '-o', 'picture.svg');
  if (svg.code !== 0 || !existsSync(join(folder, 'picture.svg')))
    fail(project, 'gq render -o picture.svg', `expected a picture\n    ${lastLines(svg)}`);
  const png = await gq(folder, 'render', USUAL_LEVEL, '-o', 'picture.png');
  if (hasPng) {
    if (png.code !== 0 || !existsSync(join(folder, 'picture.png')))
      fail(project, 'gq render -o picture.png', `expected a picture\n    ${lastLines(png)}`);
  } else if (
    png.code !== 2 ||
    !png.stderr.includes('npm install --save-dev @resvg/resvg-js') ||
    existsSync(join(folder, 'picture.png'))
  ) {
    fail(
      project,
      'gq render -o picture.png',
      `expected exit code 2 and how to install @resvg/resvg-js, found ${png.code}\n    ${lastLines(png)}`,
    );
  }
}

// --- all of it

const began = performance.now();
const folder = mkdtempSync(join(tmpdir(), 'gq-try-'));
let expected;
try {
  for (const entry of MODULES) {
    if (!existsSync(join(TRIALS, `${trialOf(entry)}.ts`)))
      throw new Error(`.ci/try-package/${trialOf(entry)}.ts is missing: it tries the entry ${entry}`);
  }
  const packed = await run('npm', ['pack', '--ignore-scripts', '--silent', '--pack-destination', folder], { cwd: PROJECT });
  if (packed.code !== 0) throw new Error(`npm pack\n${lastLines(packed)}`);
  const toolkit = join(folder, `${manifest.name}-${manifest.version}.tgz`);
  const engine = packEngine(folder);

  const ofToolkit = join(folder, 'toolkit');
  const ofEngine = join(folder, 'engine');
  const lean = join(folder, 'lean');
  const tools = join(folder, 'tools');
  const versions = Object.entries(TYPESCRIPTS).map(([name, version]) => `${name}@npm:typescript@${version}`);
  // what waits for the network, and what waits for a processor, side by side
  [expected] = await Promise.all([
    expectations(),
    lint(toolkit),
    lint(engine),
    install(ofToolkit, [toolkit]),
    install(ofEngine, [engine]),
    install(lean, [toolkit, '--omit=optional']),
    install(tools, versions),
  ]);
  report(manifest.name, ofToolkit);
  for (const entry of SCRIPTS) {
    const path = join('node_modules', manifest.name, manifest.exports[entry]);
    if (!existsSync(join(ofToolkit, path))) fail(manifest.name, entry, `expected the file ${path}, found none`);
  }
  const ofTheEngine = report(ENGINE_NAME, ofEngine);
  const burden = ['hono', 'commander', '@resvg/resvg-js', 'chokidar', manifest.name].filter((name) => ofTheEngine.has(name));
  if (burden.length > 0) fail(ENGINE_NAME, 'installed', `expected no part of the command, found ${burden.join(', ')}`);
  for (const project of [ofToolkit, ofEngine])
    symlinkSync(join(PROJECT, 'node_modules/phaser'), join(project, 'node_modules/phaser'), 'junction');

  await writeTrials(ofToolkit, manifest.name, MODULES);
  await writeTrials(ofEngine, ENGINE_NAME, ENGINE_ENTRIES);
  const json = JSONS.map(
    (entry, i) => `import json${i} from '${manifest.name}${entry.slice(1)}';\nexport const name${i}: object = json${i};`,
  );
  write(join(ofToolkit, 'src/json.ts'), `${json.join('\n')}\n`);

  await each([
    () => inBrowser(ofToolkit, MODULES),
    ...Object.keys(TYPESCRIPTS).flatMap((version) => {
      const common = { tools, version };
      const ofAll = { ...common, folder: ofToolkit, name: manifest.name };
      // Node's resolution by its two names
      const node = OLD_TYPESCRIPTS.includes(version) ? 'node16' : 'nodenext';
      const isNewest = version === 'ts70';
      const most = isNewest ? MODULES : MODULES.filter((entry) => !PHASER.test(entry));
      const ofEngineAlone = { ...common, folder: ofEngine, name: ENGINE_NAME, resolution: node };
      return [
        () => inTypeScript({ ...ofAll, resolution: node, entries: MODULES }),
        // those between the oldest and the newest differ in what they can read, not in how they find it
        ...(isNewest || version === 'ts50'
          ? [
              () => inTypeScript({ ...ofAll, resolution: 'bundler', entries: most }),
              () => inTypeScript({ ...ofEngineAlone, entries: ENGINE_ENTRIES.filter((entry) => most.includes(entry)) }),
            ]
          : []),
      ];
    }),
    () => inNode(`ES modules in Node, ${manifest.name}`, ofToolkit, ['run.js', './esm'], [...MODULES, ...JSONS]),
    () => inNode(`require in Node, ${manifest.name}`, ofToolkit, ['run.cjs'], [...MODULES, ...JSONS]),
    () => inNode(`ES modules in Node, ${ENGINE_NAME}`, ofEngine, ['run.js', './esm'], ENGINE_ENTRIES),
    () => inNode(`require in Node, ${ENGINE_NAME}`, ofEngine, ['run.cjs'], ENGINE_ENTRIES),
    () => tryCommand('installed in full', ofToolkit, true),
    () => tryCommand('installed with --omit=optional', lean, false),
  ]);
} catch (error) {
  failures.push(error instanceof Error ? error.message : String(error));
} finally {
  if (process.env.GQ_KEEP === undefined) rmSync(folder, { recursive: true, force: true });
  else console.log(folder);
}

for (const failure of failures) console.error(`failed: ${failure}`);
const seconds = ((performance.now() - began) / 1000).toFixed(0);
console.log(
  `${MODULES.length} modules and ${JSONS.length} schemas tried, ${failures.length} ${failures.length === 1 ? 'problem' : 'problems'}, ${seconds} s`,
);
if (failures.length > 0) process.exitCode = 1;
