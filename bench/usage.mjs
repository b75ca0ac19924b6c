// preloaded into a process whose use of processor and memory a benchmark wants to know
import { readFileSync, writeFileSync } from 'node:fs';
import process from 'node:process';
import { isMainThread } from 'node:worker_threads';

/** kB at most; Linux hands `maxRSS` of the process that started this one on, so its own high-water mark comes first. */
function peakMemory() {
  try {
    return Number(/VmHWM:\s+(\d+) kB/.exec(readFileSync('/proc/self/status', 'utf8'))[1]);
  } catch {
    return process.resourceUsage().maxRSS;
  }
}

if (isMainThread) {
  process.on('exit', () => {
    writeFileSync(process.env.GQ_USAGE, JSON.stringify({ ...process.resourceUsage(), maxRSS: peakMemory() }));
  });
}
