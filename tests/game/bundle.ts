import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { build as buildPage } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** A module as a bundler makes it for a page: minified, without what is not used. */
export interface Bundle {
  readonly code: string;
  /** The files that it is made of, from the root of the project. */
  readonly files: readonly string[];
}

/** Bundles a module by esbuild. It may import files of the project by their path from its root: `./engine/index.ts`. */
export async function byEsbuild(source: string): Promise<Bundle> {
  const { outputFiles, metafile } = await build({
    stdin: { contents: source, resolveDir: root, loader: 'ts' },
    absWorkingDir: root,
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'none',
    write: false,
    metafile: true,
    logLevel: 'error',
  });
  const [{ inputs }] = Object.values(metafile.outputs);
  return { code: outputFiles[0].text, files: Object.keys(inputs).filter((file) => inputs[file].bytesInOutput > 0) };
}

/** Bundles a module by Vite, whose bundler is Rolldown. */
export async function byVite(source: string): Promise<Bundle> {
  const entry = `${root}entry-of-the-test.ts`;
  const result = await buildPage({
    configFile: false,
    root,
    logLevel: 'error',
    publicDir: false,
    plugins: [
      {
        name: 'entry',
        enforce: 'pre',
        resolveId: (id) => (id === entry ? id : null),
        load: (id) => (id === entry ? source : null),
      },
    ],
    build: {
      write: false,
      target: 'es2022',
      rolldownOptions: { input: entry, preserveEntrySignatures: 'strict', output: { format: 'es' } },
    },
  });
  const outputs = (Array.isArray(result) ? result : [result]).flatMap((r) => ('output' in r ? r.output : []));
  const [{ code, modules }] = outputs.filter((o) => o.type === 'chunk');
  return { code, files: Object.keys(modules).filter((file) => modules[file].renderedLength > 0) };
}

/** What a page loads of it, bytes: as servers compress it. */
export const zipped = ({ code }: Bundle): number => gzipSync(code, { level: 9 }).length;

/** The exports of a bundle, run in this process. */
export const run = async (bundle: Bundle): Promise<Record<string, never>> =>
  await import(/* @vite-ignore */ `data:text/javascript;base64,${Buffer.from(bundle.code).toString('base64')}`);
