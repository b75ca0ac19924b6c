#!/usr/bin/env node
import { readFileSync } from 'node:fs';
import process from 'node:process';

// each command loads what it needs itself: `gq --version` must start as fast as node does
const args = process.argv.slice(2);
if (args.length === 1 && (args[0] === '--version' || args[0] === '-V')) {
  const manifest = readFileSync(new URL('../../package.json', import.meta.url), 'utf8');
  // a closed pipe (`gq --version | true`) is no error
  process.stdout.on('error', () => {});
  process.stdout.write(`${JSON.parse(manifest).version}\n`);
} else {
  const { runCommandLine } = await import('./command-line.ts');
  process.exitCode = await runCommandLine(args);
}
