// npm run bench -- NAME [options]: runs a benchmark, prints what it found, and ends with 1 if a claim is not met; see README.md

import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { type Bench, flag, optionName, publish, readOptions } from './harness/index.ts';
import { BENCHES } from './list.ts';

/** Of every benchmark. */
const COMMON = { json: flag('prints the report as JSON'), help: flag('says the options') };

const limitOf = ({ what, bound, limit }: Bench['claims'][string]): string => `${what}: ${bound} ${limit}`;

/** Every benchmark with what it claims. */
async function list(): Promise<void> {
  for (const [name, load] of Object.entries(BENCHES)) {
    const { what, claims } = (await load()).bench;
    console.log(`${name.padEnd(12)} ${what}`);
    for (const claim of Object.values(claims)) console.log(`${' '.repeat(15)}${limitOf(claim)}`);
  }
}

/** What a benchmark can be told. */
function help(name: string, bench: Bench): void {
  console.log(`npm run bench -- ${name} [options]\n\n${bench.what}\n`);
  for (const [key, { what, otherwise, isFlag }] of Object.entries({ ...COMMON, ...bench.options })) {
    const left = isFlag || otherwise === null ? '' : ` (${otherwise})`;
    console.log(`  --${optionName(key).padEnd(16)} ${what}${left}`);
  }
}

async function main([name, ...args]: readonly string[]): Promise<void> {
  if (name === undefined || name === '--list') return list();
  if (!Object.hasOwn(BENCHES, name)) {
    throw new Error(`expected the name of a benchmark, found ${name}: npm run bench -- --list names them`);
  }
  const { bench } = await BENCHES[name]();
  const asked = readOptions({ ...COMMON, ...bench.options }, args);
  if (asked.help) return help(name, bench);
  if (!(bench.flags ?? []).every((one) => process.execArgv.includes(one))) {
    const again = [...(bench.flags ?? []), ...process.argv.slice(1)];
    process.exitCode = spawnSync(process.execPath, again, { stdio: 'inherit' }).status ?? 1;
    return;
  }
  const isMet = publish(bench, await bench.run(asked as never), asked.json === true);
  if (!isMet) process.exitCode = 1;
}

await main(process.argv.slice(2)).catch((error: unknown) => {
  console.error(error instanceof Error && /^(--|expected|Unknown|Unexpected)/.test(error.message) ? error.message : error);
  process.exitCode = 2;
});
