import process from 'node:process';
import { type ConfigOptions, type Configuration, chosenConfig, noConfiguration } from './configuration.ts';

export {
  addConfigOptions,
  CONFIG_NAME,
  type ConfigOptions,
  type Configuration,
  type ConfiguredTerms,
  chosenConfig,
  configFolders,
  findConfig,
  noConfiguration,
  termsIn,
  termsSaid,
} from './configuration.ts';

/**
 * Reads the configuration that the options choose. Without a file, the code that reads one is not loaded: it needs the schema.
 * @param folder the search for it starts here and goes upwards
 * @throws Failure if it can't be read or is invalid, with every problem and its place
 */
export async function readConfiguration(options: ConfigOptions, folder: string = process.cwd()): Promise<Configuration> {
  const file = chosenConfig(options, folder);
  return file === null ? noConfiguration() : (await import('./read.ts')).readConfigurationFile(file);
}
