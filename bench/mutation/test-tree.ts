type Deed = (...args: never[]) => unknown;

interface Suite {
  readonly suites: (Suite | Test)[];
  readonly before: Deed[];
  readonly after: Deed[];
  readonly beforeEach: Deed[];
  readonly afterEach: Deed[];
}

interface Test {
  readonly run: () => unknown;
}

/** The result of running some of a file's tests: the first failure, or none. */
export interface TestResult {
  readonly error: unknown;
  readonly test: number;
}

const empty = (): Suite => ({ suites: [], before: [], after: [], beforeEach: [], afterEach: [] });

// the suite that is being described: test files are loaded one after the other. Modules are dropped between mutants; globals
// are not
const shared = globalThis as { mutationSuite?: Suite };
const current = (): Suite => {
  shared.mutationSuite ??= empty();
  return shared.mutationSuite;
};

/** Collects the tests that a file describes while it is loaded. */
export async function collect(load: () => Promise<unknown>): Promise<Suite> {
  const root = empty();
  shared.mutationSuite = root;
  await load();
  return root;
}

/** Runs the requested tests, given by their indices in the file, one after the other until one fails. */
export async function runTests(
  root: Suite,
  isWanted: (test: number) => boolean,
  around: (test: number, run: () => Promise<void>) => Promise<void>,
): Promise<TestResult | null> {
  let number = 0;
  let failure: TestResult | null = null;
  const wants = new Map<Suite | Test, boolean>();
  const numbers = new Map<Test, number>();
  const look = (suite: Suite): boolean => {
    let any = false;
    for (const one of suite.suites) {
      let wanted: boolean;
      if ('run' in one) {
        numbers.set(one, number);
        wanted = isWanted(number++);
      } else wanted = look(one);
      wants.set(one, wanted);
      any ||= wanted;
    }
    return any;
  };
  const attempt = async (test: number, run: () => unknown): Promise<void> => {
    try {
      await run();
    } catch (error) {
      failure ??= { error, test };
    }
  };
  const runSuite = async (suite: Suite, each: readonly Suite[]): Promise<void> => {
    for (const deed of suite.before) await attempt(-1, deed as () => unknown);
    for (const one of suite.suites) {
      if (failure !== null) break;
      if (wants.get(one) !== true) continue;
      if (!('run' in one)) {
        await runSuite(one, [...each, one]);
        continue;
      }
      const n = numbers.get(one) as number;
      await attempt(n, () =>
        around(n, async () => {
          try {
            for (const outer of each) for (const deed of outer.beforeEach) await (deed as () => unknown)();
            await one.run();
          } finally {
            for (const outer of each.toReversed()) for (const deed of outer.afterEach) await (deed as () => unknown)();
          }
        }),
      );
    }
    for (const deed of suite.after) await attempt(-1, deed as () => unknown);
  };
  if (look(root)) await runSuite(root, [root]);
  return failure;
}

/** The number of tests in a file. */
export const countTests = (suite: Suite): number =>
  suite.suites.reduce((sum, one) => sum + ('run' in one ? 1 : countTests(one)), 0);

const row = (value: unknown): unknown[] => (Array.isArray(value) ? value : [value]);
// options may stand before the function or after it
const deedOf = (args: readonly unknown[]): Deed => args.find((arg) => typeof arg === 'function') as Deed;

function describeNow(_name: string, ...rest: unknown[]): void {
  const outer = current();
  const suite = empty();
  outer.suites.push(suite);
  shared.mutationSuite = suite;
  try {
    (deedOf(rest) as () => void)();
  } finally {
    shared.mutationSuite = outer;
  }
}
const nothing = Object.assign(() => {}, { each: () => () => {} });

/** Replaces `describe` of vitest. */
export const describe = Object.assign(describeNow, {
  each:
    (table: readonly unknown[]) =>
    (name: string, ...rest: unknown[]) => {
      for (const one of table) describeNow(name, () => deedOf(rest)(...(row(one) as never[])));
    },
  skipIf: (skips: unknown) => (skips ? nothing : describeNow),
  runIf: (runs: unknown) => (runs ? describeNow : nothing),
  skip: nothing,
});

function testNow(_name: string, ...rest: unknown[]): void {
  const run = deedOf(rest) as () => unknown;
  current().suites.push({ run: () => run() });
}

/** Replaces `it` and `test` of vitest. */
export const it = Object.assign(testNow, {
  each:
    (table: readonly unknown[]) =>
    (_name: string, ...rest: unknown[]) => {
      for (const one of table) current().suites.push({ run: () => deedOf(rest)(...(row(one) as never[])) });
    },
  skipIf: (skips: unknown) => (skips ? nothing : testNow),
  runIf: (runs: unknown) => (runs ? testNow : nothing),
  skip: nothing,
});

export const beforeAll = (deed: Deed): unknown => current().before.push(deed);
export const afterAll = (deed: Deed): unknown => current().after.push(deed);
export const beforeEach = (deed: Deed): unknown => current().beforeEach.push(deed);
export const afterEach = (deed: Deed): unknown => current().afterEach.push(deed);
