import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { chooseShard, type Environment } from '../../cli/fleet/index.ts';
import { Failure } from '../../cli/terminal/messages.ts';

/** How each system numbers a process: written down a second time, from the documentation of each. */
const ENVIRONMENTS: Readonly<Record<string, (shard: number, total: number) => Record<string, string>>> = {
  GQ_SHARD: (shard, total) => ({ GQ_SHARD: `${shard + 1}/${total}` }),
  GitLab: (shard, total) => ({ CI_NODE_INDEX: `${shard + 1}`, CI_NODE_TOTAL: `${total}` }),
  CircleCI: (shard, total) => ({ CIRCLE_NODE_INDEX: `${shard}`, CIRCLE_NODE_TOTAL: `${total}` }),
  Buildkite: (shard, total) => ({ BUILDKITE_PARALLEL_JOB: `${shard}`, BUILDKITE_PARALLEL_JOB_COUNT: `${total}` }),
  'Azure Pipelines': (shard, total) => ({ SYSTEM_JOBPOSITIONINPHASE: `${shard + 1}`, SYSTEM_TOTALJOBSINPHASE: `${total}` }),
  Semaphore: (shard, total) => ({ SEMAPHORE_JOB_INDEX: `${shard + 1}`, SEMAPHORE_JOB_COUNT: `${total}` }),
  Bitbucket: (shard, total) => ({ BITBUCKET_PARALLEL_STEP: `${shard}`, BITBUCKET_PARALLEL_STEP_COUNT: `${total}` }),
  'AWS Batch': (shard, total) => ({ AWS_BATCH_JOB_ARRAY_INDEX: `${shard}`, AWS_BATCH_JOB_ARRAY_SIZE: `${total}` }),
  Slurm: (shard) => ({ SLURM_ARRAY_TASK_ID: `${shard}` }),
  Kubernetes: (shard) => ({ JOB_COMPLETION_INDEX: `${shard}` }),
};
const SYSTEMS = Object.entries(ENVIRONMENTS);
/** Systems that say how many processes there are. */
const WITH_TOTAL = SYSTEMS.filter(([name]) => name !== 'Slurm' && name !== 'Kubernetes');
const WITHOUT_TOTAL = SYSTEMS.filter(([name]) => name === 'Slurm' || name === 'Kubernetes');

const shardOf = (asked: string, environment: Environment, total: number | null) => chooseShard(asked, environment, total).shard;

/** The message of the failure; any other error, and none, fails the test. */
function refused(asked: string, environment: Environment, total: number | null): string {
  try {
    const chosen = chooseShard(asked, environment, total);
    throw new Error(`expected a refusal, found ${JSON.stringify(chosen)}`);
  } catch (error) {
    if (error instanceof Failure) return error.message;
    throw error;
  }
}

const shardAndTotal = fc
  .integer({ min: 1, max: 1_000_000 })
  .chain((total) => fc.tuple(fc.nat({ max: total - 1 }), fc.constant(total)));

describe.each(SYSTEMS)('%s', (name, environmentOf) => {
  it('numbers the processes of a job so that each shard is done once', () => {
    fc.assert(
      fc.property(fc.integer({ min: 1, max: 40 }), (total) => {
        const done = Array.from({ length: total }, (_, i) => shardOf('auto', environmentOf(i, total), total));
        expect(done).toEqual(Array.from({ length: total }, (_, i) => i));
      }),
    );
  });

  it('is found for any shard of any plan, and named with its values', () => {
    fc.assert(
      fc.property(shardAndTotal, ([shard, total]) => {
        const environment = environmentOf(shard, total);
        const chosen = chooseShard('auto', environment, total);
        expect(chosen).toMatchObject({ shard, total });
        expect(chosen.message).toContain(`shard ${shard} (${shard + 1}/${total})`);
        for (const [variable, value] of Object.entries(environment)) expect(chosen.message).toContain(`${variable}=${value}`);
        if (name !== 'GQ_SHARD') expect(chosen.message).toContain(name);
      }),
    );
  });

  it('gives way to a shard that is named', () => {
    fc.assert(
      fc.property(shardAndTotal, ([shard, total]) => {
        expect(shardOf(`${shard}`, environmentOf(0, 3), total)).toBe(shard);
        expect(shardOf(`${shard + 1}/${total}`, environmentOf(0, 3), total)).toBe(shard);
        expect(shardOf('auto', { ...environmentOf(0, 3), GQ_SHARD: `${shard + 1}/${total}` }, total)).toBe(shard);
      }),
    );
  });

  it('is refused past the last shard', () => {
    fc.assert(
      fc.property(shardAndTotal, ([over, total]) => {
        expect(refused('auto', environmentOf(total + over, total), total)).toMatch(/expected 0( to \d+)?, counted from 0/);
      }),
    );
  });

  it.each(Object.keys(environmentOf(2, 8)))('is refused if %s is no number', (variable) => {
    for (const value of [
      '',
      ' ',
      'x',
      '-1',
      '1.5',
      '1e1',
      '0x1',
      ' 1',
      '1 ',
      '+1',
      '9'.repeat(20),
      '4294967294',
      '١',
      '1\u0000',
      'NaN',
      '8/',
    ]) {
      const message = refused('auto', { ...environmentOf(2, 8), [variable]: value }, 8);
      expect(message).toContain(`${variable}=`);
      expect(message).toMatch(/expected/);
    }
  });
});

describe.each(WITH_TOTAL)('%s, which knows the total', (_, environmentOf) => {
  it('needs no plan', () => {
    expect(chooseShard('auto', environmentOf(4, 9), null)).toMatchObject({ shard: 4, total: 9 });
  });

  it('is refused if the plan has another number of shards', () => {
    fc.assert(
      fc.property(shardAndTotal, fc.integer({ min: 1, max: 1_000_000 }), ([shard, total], planned) => {
        fc.pre(planned !== total);
        expect(refused('auto', environmentOf(shard, total), planned)).toMatch(
          new RegExp(`expected ${planned} shards?, as in the plan, found ${total}$`),
        );
      }),
    );
  });

  it('is refused if the total is 0', () => {
    const environment = Object.fromEntries(
      Object.entries(environmentOf(0, 1)).map(([variable, value]) => [
        variable,
        /TOTAL|COUNT|SIZE/.test(variable) ? '0' : value.replace('/1', '/0'),
      ]),
    );
    expect(refused('auto', environment, null)).toMatch(/at least one/);
    expect(refused('auto', environment, 1)).toMatch(/expected/);
  });
});

describe.each(WITH_TOTAL.filter(([name]) => name !== 'GQ_SHARD'))('%s without one of its variables', (_, environmentOf) => {
  const [index, total] = Object.keys(environmentOf(0, 1));

  it('takes the total from the plan', () => {
    const { [index]: position } = environmentOf(5, 8);
    const chosen = chooseShard('auto', { [index]: position }, 8);
    expect(chosen).toMatchObject({ shard: 5, total: 8 });
    expect(chosen.message).toMatch(/the total is from the plan/);
    expect(refused('auto', { [index]: position }, null)).toMatch(/not known how many shards/);
  });

  // a pipeline in which every process did everything, or the first shard, would be green without having checked the rest
  it('is refused without the index', () => {
    for (const planned of [8, 1, null]) expect(refused('auto', { [total]: '8' }, planned)).toContain(`${total}=8`);
    expect(refused('auto', { [total]: '8' }, 8)).toContain(index);
  });

  it('with a total of 1 and no index is a job that is not parallel', () => {
    expect(shardOf('auto', { [total]: '1' }, 1)).toBe(0);
    expect(shardOf('auto', { [total]: '1' }, null)).toBe(0);
    expect(refused('auto', { [total]: '1' }, 8)).toMatch(/no variable says which one/);
  });
});

describe.each(WITHOUT_TOTAL)('%s, which does not know the total', (_, environmentOf) => {
  it('is refused without a plan', () => {
    expect(refused('auto', environmentOf(2, 8), null)).toMatch(/not known how many shards/);
  });
});

describe('numbers that count from 1', () => {
  it.each([
    { CI_NODE_INDEX: '0', CI_NODE_TOTAL: '8' },
    { SYSTEM_JOBPOSITIONINPHASE: '0' },
    { SEMAPHORE_JOB_INDEX: '0' },
    { GQ_SHARD: '0/8' },
  ])('are refused if they begin with 0: %j', (environment) =>
    expect(refused('auto', environment as Environment, 8)).toMatch(/from 1/),
  );
});

describe('a task of Slurm', () => {
  it('that is submitted alone is the same shard as before', () => {
    // what sbatch --array=2 sets
    const alone = { SLURM_ARRAY_TASK_ID: '2', SLURM_ARRAY_TASK_COUNT: '1', SLURM_ARRAY_TASK_MIN: '2', SLURM_ARRAY_TASK_MAX: '2' };
    expect(chooseShard('auto', alone, 8)).toMatchObject({ shard: 2, total: 8 });
    expect(refused('auto', alone, null)).toMatch(/not known how many shards/);
  });
});

describe('several systems', () => {
  it('that agree are one', () => {
    const both = { ...ENVIRONMENTS.Slurm(3, 8), ...ENVIRONMENTS.GitLab(3, 8) };
    for (const planned of [8, null]) {
      const chosen = chooseShard('auto', both, planned);
      expect(chosen).toMatchObject({ shard: 3, total: 8 });
      expect(chosen.message).toContain('SLURM_ARRAY_TASK_ID=3');
      expect(chosen.message).toContain('CI_NODE_INDEX=4');
    }
  });

  it('that disagree are refused, by name and value, whichever they are', () => {
    const systems = SYSTEMS.filter(([name]) => name !== 'GQ_SHARD').map(([, environmentOf]) => environmentOf);
    fc.assert(
      fc.property(
        fc.shuffledSubarray(systems, { minLength: 2, maxLength: 2 }),
        fc.shuffledSubarray([0, 1, 2, 3, 4, 5, 6, 7], { minLength: 2, maxLength: 2 }),
        (two, shards) => {
          const environments = two.map((environmentOf, i) => environmentOf(shards[i], 8));
          const message = refused('auto', Object.assign({}, ...environments), 8);
          expect(message).toMatch(/two systems disagree/);
          for (const [variable, value] of environments.flatMap((e) => Object.entries(e)))
            expect(message).toContain(`${variable}=${value}`);
        },
      ),
    );
  });

  it('that agree on the shard and disagree on the total are refused', () => {
    const both = { ...ENVIRONMENTS.Slurm(0, 8), ...ENVIRONMENTS.CircleCI(0, 1), ...ENVIRONMENTS['AWS Batch'](0, 8) };
    expect(refused('auto', both, 8)).toMatch(
      /CIRCLE_NODE_INDEX=0, CIRCLE_NODE_TOTAL=1 \(CircleCI\) is shard 0 \(1\/1\).*AWS_BATCH/,
    );
  });
});

describe('no system', () => {
  it('is fine where everything is one shard, and says so', () => {
    for (const planned of [1, null]) {
      const chosen = chooseShard('auto', { PATH: '/usr/bin' }, planned);
      expect(chosen).toMatchObject({ shard: 0, total: 1 });
      expect(chosen.message).toMatch(/no variable names a shard/);
    }
  });

  it('is refused for a plan of several shards', () => {
    const message = refused('auto', { PATH: '/usr/bin' }, 2);
    for (const environmentOf of Object.values(ENVIRONMENTS)) expect(message).toContain(Object.keys(environmentOf(0, 2))[0]);
  });
});

describe('--shard', () => {
  it('counts from 0 alone, and from 1 with a total', () => {
    fc.assert(
      fc.property(shardAndTotal, ([shard, total]) => {
        for (const asked of [`${shard}`, `${shard + 1}/${total}`]) {
          const chosen = chooseShard(asked, {}, total);
          expect(chosen).toMatchObject({ shard, total });
          expect(chosen.message).toContain(`--shard ${asked}`);
        }
      }),
    );
  });

  it.each([
    '',
    ' ',
    'Auto',
    '-1',
    '1.5',
    '0/8',
    '9/8',
    '8',
    '99',
    '1e0',
    '4/9',
    '4/',
    '/8',
    '4/8/1',
    '4 / 8',
    '0x4',
    '9'.repeat(30),
    `1/${'9'.repeat(30)}`,
  ])('refuses %j in a plan of 8', (asked) => expect(refused(asked, ENVIRONMENTS.Slurm(1, 8), 8)).toMatch(/^--shard .*expected/s));

  it('needs to know how many there are', () => {
    expect(shardOf('3/8', {}, null)).toBe(2);
    expect(refused('3', {}, null)).toMatch(/not known how many shards/);
  });
});
