import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

/** The engine as one classic script that leaves `gravityQuest.hashOf` behind: what a page, Bun and QuickJS evaluate. */
export async function bundleEngine(): Promise<string> {
  const entry = join(dirname(fileURLToPath(import.meta.url)), 'entry.ts');
  const result = await build({
    configFile: false,
    logLevel: 'error',
    build: { write: false, target: 'es2023', lib: { entry, formats: ['iife'], name: 'gravityQuest', fileName: 'engine' } },
  });
  const outputs = (Array.isArray(result) ? result : [result]).flatMap((r) => ('output' in r ? r.output : []));
  const chunks = outputs.filter((o) => o.type === 'chunk');
  if (chunks.length !== 1) throw new Error(`expected one chunk of the engine, found ${chunks.length}`);
  return chunks[0].code;
}
