import { extname } from 'node:path';
import { type Command, Option } from 'commander';
import { compile, simulate } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { type AccuracyOptions, addAccuracyOptions, chooseAccuracy } from '../accuracy-options.ts';
import { chooseRun } from '../chosen-run.ts';
import type { CommandResult } from '../command.ts';
import { Failure } from '../failure.ts';
import { parseHolds } from '../holds-option.ts';
import { openLevel } from '../level-source.ts';
import { maxTimeOption, wholeNumberOption } from '../options.ts';
import { renderPng, renderSvg } from '../render/index.ts';
import { writeWhole } from '../write-file.ts';

const DEFAULT_WIDTH = 1200;

interface RenderOptions extends AccuracyOptions {
  readonly output: string;
  readonly run?: string | false;
  readonly holds?: readonly Hold[];
  readonly maxTime: number;
  readonly width: number;
  readonly theme: 'dark' | 'light';
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addAccuracyOptions(command)
    .description('Draw a level and one of its runs.')
    .argument('<level>', 'a level file')
    .requiredOption('-o, --output <file>', 'FILE.svg or FILE.png; - writes SVG to the standard output')
    .option('--run <name>', 'the run to draw; the first when left out')
    .option('--no-run', 'draw the level alone')
    .option('--holds <holds>', 'draw this run instead: 12-96,130-188 (ticks); none: she drifts', parseHolds)
    .addOption(maxTimeOption())
    .option('--width <px>', 'width of the picture', wholeNumberOption('a width in px', 100, 8192), DEFAULT_WIDTH)
    .addOption(new Option('--theme <theme>', 'colours').choices(['dark', 'light']).default('dark'))
    .addHelpText(
      'after',
      `
Exit code: 0; 1 when the level is invalid; 2 when it could not be read or the picture not be written.

Examples:
  $ gq render levels/01-first-pull.level.json -o first.svg
  $ gq render levels/01-first-pull.level.json -o first.png --width 800 --theme light
  $ gq render levels/01-first-pull.level.json -o - --no-run > level.svg`,
    )
    .action(async (file: string, options: RenderOptions) => finish(await render(file, options)));
}

async function render(file: string, options: RenderOptions): Promise<CommandResult> {
  const { output, width, theme, maxTime } = options;
  const accuracy = chooseAccuracy(options);
  const kind = output === '-' ? '.svg' : extname(output).toLowerCase();
  if (kind !== '.svg' && kind !== '.png') {
    throw new Failure(`--output ${output}: expected a name that ends in .svg or .png, or - for SVG on the standard output`);
  }
  const opened = openLevel(file);
  if (!('level' in opened)) return opened;
  const svg = draw(file, opened.level, options);
  if (output === '-') return { output: svg, exitCode: 0 };
  await writeWhole(output, kind === '.svg' ? svg : await renderPng(svg, width));
  return { messages: `wrote ${output}\n`, exitCode: 0 };

  function draw(name: string, level: Parameters<typeof renderSvg>[0], { run: wanted, holds }: RenderOptions): string {
    if (wanted === false && holds !== undefined)
      throw new Failure('--no-run and --holds exclude each other: give one of the two');
    const nothingToPlay = wanted === undefined && holds === undefined && level.runs.length === 0;
    if (wanted === false || nothingToPlay) return renderSvg(level, { width, theme });
    const chosen = chooseRun(name, level, { run: wanted || undefined, holds });
    const run = simulate(compile(level, accuracy), chosen.holds, { maxTime });
    return renderSvg(level, { run, holds: chosen.holds, width, theme });
  }
}
