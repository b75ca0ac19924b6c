import { runWhole, SIGNALLED_COMMANDS, signalAt } from '../../tests/interrupted/signalled-command.ts';

/**
 * Sends signals to commands before each of their steps, command after command, each for an equal share of the time; the exit code becomes 1 when one ends otherwise than
 * it should, or writes on.
 * @param from the first step
 * @param most steps of each command
 * @param until ms since 1970; no step begins after that
 */
export async function attackSignals(from: number, most: number, until: number): Promise<void> {
  let tried = 0;
  let bugs = 0;
  const commands = Object.entries(SIGNALLED_COMMANDS);
  for (const [i, [name, command]] of commands.entries()) {
    const share = Date.now() + (until - Date.now()) / (commands.length - i);
    const whole = await runWhole(command);
    const last = Math.min(whole.steps, from + most);
    let step = from;
    for (; step < last && Date.now() < share; step++) {
      for (const signals of [['SIGINT'], ['SIGTERM'], ['SIGTERM', 'SIGINT', 'SIGTERM']] as const) {
        const wrong = await signalAt(whole, 1 + step, signals);
        if (wrong === null) continue;
        tried++;
        if (wrong.length > 0) bugs++;
        for (const what of wrong) console.log(`bug  ${name}, step ${1 + step}, ${signals.join()}: ${what}`);
      }
    }
    console.log(`${name}: steps ${1 + from} to ${step} of ${whole.steps}`);
  }
  console.log(`\n${tried} signals, ${bugs} bugs`);
  if (bugs > 0 || tried === 0) process.exitCode = 1;
}
