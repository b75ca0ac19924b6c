import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Application, ConsoleLogger, LogLevel, TSConfigReader, TypeDocReader } from 'typedoc';

// Writes the API reference of every module of the package as Markdown into dist/reference. Fails where something public has no
// description, and where a link leads nowhere.

/** Members of a type that the compiler infers, as of a zod schema, have no docstrings of their own. */
const INFERRED = /\.__type\./;

class GapLogger extends ConsoleLogger {
  gaps = 0;

  log(message, level) {
    if (level === LogLevel.Warn && INFERRED.test(message)) return;
    super.log(message, level);
    if (level >= LogLevel.Warn) this.gaps++;
  }
}

/** The sources of the modules that the package exports. */
const { exports } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));
const entryPoints = Object.entries(exports)
  .filter(([, { types }]) => types !== undefined)
  .map(([, { types }]) => types.replace(/^\.\/dist\/(.*)\.d\.ts$/, '../../$1.ts'));

process.chdir(fileURLToPath(new URL('./', import.meta.url)));
const app = await Application.bootstrapWithPlugins({ entryPoints }, [new TypeDocReader(), new TSConfigReader()]);
const logger = new GapLogger();
logger.level = LogLevel.Warn;
app.logger = logger;

const project = await app.convert();
if (project === undefined) process.exit(2);
app.validate(project);
if (logger.gaps > 0) {
  console.error(`the API reference has ${logger.gaps} gaps: describe what is named above in its docstring`);
  process.exit(1);
}
await app.generateOutputs(project);
if (logger.gaps > 0) process.exit(1);
