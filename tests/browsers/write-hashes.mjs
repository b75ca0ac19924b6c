import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

// Rewrites hashes.json, and the identity of the engine that follows from it, from the sources as they are: `npm run hashes`, and
// say in the commit why they changed.
const here = dirname(fileURLToPath(import.meta.url));
const identityFile = join(here, '../../game/play/engine-id.ts');
const server = await createServer({ configFile: false, logLevel: 'error', root: here, server: { middlewareMode: true } });
try {
  const { committedTable, tableHere } = await server.ssrLoadModule('/hash-table.ts');
  const { hashedRuns } = await server.ssrLoadModule('/scenes.ts');
  const { nextEngineId, pinnedResults, withIdentity } = await server.ssrLoadModule('/engine-identity.ts');
  const { ENGINE_ID } = await server.ssrLoadModule(identityFile);
  const before = committedTable();
  const table = tableHere(hashedRuns());
  const id = nextEngineId(ENGINE_ID, before, table);
  writeFileSync(join(here, 'hashes.json'), `${JSON.stringify(table, null, 2)}\n`);
  writeFileSync(identityFile, withIdentity(readFileSync(identityFile, 'utf8'), id, pinnedResults(table)));
  console.log(`${Object.keys(table).length} runs hashed; the engine is ${id}${id === ENGINE_ID ? ', as before' : ''}`);
} finally {
  await server.close();
}
