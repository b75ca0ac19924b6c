import { type ChildProcess, execFileSync, spawn } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { hostname, tmpdir, userInfo } from 'node:os';
import { delimiter, join } from 'node:path';
import process from 'node:process';
import { setTimeout } from 'node:timers/promises';

/** Where Debian puts the services. */
const PATH = [process.env.PATH, '/usr/sbin'].join(delimiter);

const PROGRAMS = ['munged', 'slurmctld', 'slurmd', 'sbatch', 'squeue', 'scancel', 'sinfo'];

/** The programs of Slurm and munge that this machine does not have. */
export const missingPrograms = (): string[] =>
  PROGRAMS.filter((name) => !PATH.split(delimiter).some((folder) => existsSync(join(folder, name))));

/** ms between two looks at the cluster; each starts a program */
const PAUSE = 400;

/** s after which a node that does not answer is taken for lost */
const NODE_TIMEOUT = 4;

/** s of a credential; the tasks of a lost node begin again only when theirs have ended */
const LIFETIME = 5;

/** A Slurm cluster of two nodes with two processors each, all on this machine. */
export interface Cluster {
  /** What commands of Slurm need in their environment. */
  readonly env: Readonly<Record<string, string>>;
  /** The tasks that run: their names, as 7_3, and nodes. */
  running(job: string): readonly { readonly task: string; readonly id: string; readonly node: string }[];
  /** Kills a task as the system does when memory runs out. */
  killTask(task: string): void;
  /** Kills a node with everything that it runs, all at once. */
  killNode(node: string): void;
  /** Waits until jobs have ended, however. */
  ended(...jobs: readonly string[]): Promise<void>;
  stop(): Promise<void>;
}

const freePorts = async (count: number): Promise<number[]> => {
  const servers = await Promise.all(
    Array.from({ length: count }, async () => {
      const server = createServer();
      await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
      return server;
    }),
  );
  const ports = servers.map((server) => (server.address() as { port: number }).port);
  for (const server of servers) server.close();
  return ports;
};

/** @throws Error with what the services have said, if they don't come up */
export async function startCluster(): Promise<Cluster> {
  // short, since the path of a socket may not be long
  const folder = mkdtempSync(join(tmpdir(), 'gqs-'));
  const at = (name: string): string => join(folder, name);
  for (const name of ['state', 'spool-n1', 'spool-n2']) mkdirSync(at(name));
  writeFileSync(at('munge.key'), randomBytes(128), { mode: 0o600 });
  const [control, first, second] = await freePorts(3);
  const user = userInfo().username;
  const node = (name: string, port: number): string =>
    `NodeName=${name} NodeHostname=${hostname()} NodeAddr=127.0.0.1 Port=${port} CPUs=2`;
  writeFileSync(
    at('slurm.conf'),
    `ClusterName=gq
SlurmctldHost=${hostname()}(127.0.0.1)
SlurmctldPort=${control}
SlurmUser=${user}
SlurmdUser=${user}
AuthType=auth/munge
AuthInfo=socket=${at('munge.socket')},cred_expire=${LIFETIME}
StateSaveLocation=${at('state')}
SlurmdSpoolDir=${at('spool-%n')}
SlurmctldPidFile=${at('slurmctld.pid')}
SlurmdPidFile=${at('%n.pid')}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=${NODE_TIMEOUT}
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
${node('n1', first)}
${node('n2', second)}
PartitionName=p Nodes=n1,n2 Default=YES State=UP
`,
  );
  const env = { SLURM_CONF: at('slurm.conf'), PATH };
  const services = new Map<string, ChildProcess>();
  const said: string[] = [];
  const start = (name: string, program: string, ...args: readonly string[]): void => {
    const child = spawn(program, args, { env: { ...process.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (data: Buffer) => said.push(data.toString()));
    child.on('error', (error) => said.push(`${program}: ${error.message}\n`));
    services.set(name, child);
  };
  const ask = (program: string, ...args: readonly string[]): string =>
    execFileSync(program, args, { env: { ...process.env, ...env }, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  const hasEnded = (name: string): boolean => {
    const child = services.get(name);
    return child !== undefined && (child.exitCode !== null || child.signalCode !== null);
  };
  const comesUp = async (isUp: () => boolean): Promise<void> => {
    while (!isUp()) {
      if ([...services.keys()].some(hasEnded)) throw new Error(`the cluster does not come up:\n${said.join('')}`);
      await setTimeout(PAUSE);
    }
  };
  const isTrue = (check: () => boolean): boolean => {
    try {
      return check();
    } catch {
      // the controller does not answer yet
      return false;
    }
  };

  const cluster: Cluster = {
    env,
    running: (job) =>
      ask('squeue', '--noheader', '--array', '--states=R', '--jobs', job, '--format=%i %A %N')
        .split('\n')
        .filter((line) => line !== '')
        .map((line) => {
          const [task, id, name] = line.split(' ');
          return { task, id, node: name };
        }),
    killTask: (task) => void ask('scancel', '--signal=KILL', '--full', task),
    killNode(name) {
      const ids = ask('squeue', '--noheader', '--array', '--states=R', '--nodelist', name, '--format=%A')
        .split('\n')
        .filter(Boolean);
      // first those that would report the end of a task
      for (const pid of processes((words) => ids.some((id) => words.startsWith(`slurmstepd: [${id}.`)))) kill(pid);
      services.get(name)!.kill('SIGKILL');
      for (const pid of processesOf((variables) => ids.some((id) => variables.includes(`SLURM_JOB_ID=${id}`)))) kill(pid);
    },
    async ended(...jobs) {
      while (ask('squeue', '--noheader', '--jobs', jobs.join(',')).trim() !== '') await setTimeout(PAUSE);
    },
    async stop() {
      isTrue(() => ask('scancel', '--user', user) === '');
      // what tasks have started, too
      for (const pid of processesOf((variables) => variables.includes(`SLURM_CONF=${at('slurm.conf')}`))) kill(pid);
      for (const child of services.values()) child.kill('SIGKILL');
      await Promise.all(
        [...services.keys()].map(async (name) => {
          while (!hasEnded(name)) await setTimeout(PAUSE);
        }),
      );
      rmSync(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: PAUSE });
    },
  };

  try {
    const files = ['socket', 'key-file', 'pid-file', 'log-file', 'seed-file'].map(
      (option) => `--${option}=${at(`munge.${option.replace('-file', '')}`)}`,
    );
    // --force: the folder for temporary files may be written by all
    start('munged', 'munged', '--foreground', '--force', ...files);
    await comesUp(() => existsSync(at('munge.socket')));
    start('slurmctld', 'slurmctld', '-D');
    start('n1', 'slurmd', '-D', '-N', 'n1');
    start('n2', 'slurmd', '-D', '-N', 'n2');
    await comesUp(() => isTrue(() => ask('sinfo', '--noheader', '--Node', '--format=%T').trim() === 'idle\nidle'));
    return cluster;
  } catch (error) {
    await cluster.stop();
    throw error;
  }
}

function kill(pid: number): void {
  try {
    process.kill(pid, 'SIGKILL');
  } catch {
    // it has ended by itself
  }
}

/** The numbers of processes by a file that the system shows of each. */
function processesBy(file: 'cmdline' | 'environ', passes: (words: string[]) => boolean): number[] {
  return readdirSync('/proc')
    .filter((name) => /^\d+$/.test(name) && Number(name) !== process.pid)
    .filter((name) => {
      try {
        return passes(readFileSync(`/proc/${name}/${file}`, 'utf8').split('\0'));
      } catch {
        return false;
      }
    })
    .map(Number);
}

const processes = (passes: (command: string) => boolean): number[] => processesBy('cmdline', (words) => passes(words.join(' ')));
const processesOf = (passes: (variables: readonly string[]) => boolean): number[] => processesBy('environ', passes);
