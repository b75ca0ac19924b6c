// preloaded into a process whose use of processor and memory a benchmark wants to know
import { writeFileSync } from 'node:fs';
import process from 'node:process';
import { isMainThread } from 'node:worker_threads';

if (isMainThread) process.on('exit', () => writeFileSync(process.env.GQ_USAGE, JSON.stringify(process.resourceUsage())));
