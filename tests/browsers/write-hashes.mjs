import { writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

// Rewrites hashes.json from the sources as they are: `npm run hashes`, and say in the commit why they changed.
const here = dirname(fileURLToPath(import.meta.url));
const server = await createServer({ configFile: false, logLevel: 'error', root: here, server: { middlewareMode: true } });
try {
  const { tableHere } = await server.ssrLoadModule('/hash-table.ts');
  const { hashedRuns } = await server.ssrLoadModule('/scenes.ts');
  const table = tableHere(hashedRuns());
  writeFileSync(join(here, 'hashes.json'), `${JSON.stringify(table, null, 2)}\n`);
  console.log(`${Object.keys(table).length} runs hashed`);
} finally {
  await server.close();
}
