/** ms that a database has to answer */
const PATIENCE = 5000;

/**
 * @param stores by name
 * @param isChecked whether the database may have been replaced, for example after its data was cleared: work that relies on
 * existing data must check for it first
 */
type Work<T> = (stores: (name: string) => IDBObjectStore, isChecked: boolean) => T | Promise<T>;

/** A database of the browser. Every promise rejects if it fails or does not answer in time; then nothing is changed. */
interface Database {
  /**
   * Runs in one transaction, in order of the calls, and resolves once the browser has written it to disk. If the page dies before
   * that, an end of the sequence of transactions may be missing: Chromium aborts all that it has not finished. Work that returns
   * no promise is handed over completely when this returns, so nothing of the page is needed after that.
   */
  within<T>(mode: IDBTransactionMode, work: Work<T>): Promise<T>;
}

interface DatabaseOptions {
  readonly databases: IDBFactory;
  readonly name: string;
  /** The key paths of its stores by name; null: keys are given explicitly. */
  readonly stores: Readonly<Record<string, string | string[] | null>>;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: (ms: number, call: () => void) => () => void;
}

export const done = <T>(request: IDBRequest<T>): Promise<T> =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

const finished = (transaction: IDBTransaction): Promise<void> =>
  new Promise((resolve, reject) => {
    const fail = () => reject(transaction.error ?? new DOMException('the transaction was aborted', 'AbortError'));
    transaction.addEventListener('complete', () => resolve());
    transaction.addEventListener('abort', fail);
  });

/** Opens a database and creates its stores if it is new. Resolves when the database answers, however long that takes. */
export async function openDatabase({ databases, name, stores, after }: DatabaseOptions): Promise<Database> {
  const names = Object.keys(stores);
  const open = async (): Promise<IDBDatabase> => {
    const request = databases.open(name, 1);
    request.onupgradeneeded = () => {
      for (const [store, keyPath] of Object.entries(stores))
        request.result.createObjectStore(store, keyPath === null ? {} : { keyPath });
    };
    const opened = await done(request);
    // the user clears the data of the site, which must not wait for this page
    opened.onversionchange = () => opened.close();
    return opened;
  };
  let database = await open();

  const inTime = <T>(answer: Promise<T>): Promise<T> =>
    new Promise((resolve, reject) => {
      const late = () => reject(new DOMException('it does not answer', 'TimeoutError'));
      const forget = after(PATIENCE, late);
      void answer.then(resolve, reject).finally(forget);
    });
  const run = async <T>(mode: IDBTransactionMode, work: Work<T>, isChecked: boolean): Promise<T> => {
    const transaction = database.transaction(names, mode, { durability: 'strict' });
    const end = finished(transaction);
    // the work or the end reports the reason, whichever fails first
    end.catch(() => undefined);
    let result: T;
    try {
      const given = work((store) => transaction.objectStore(store), isChecked);
      if (given instanceof Promise) result = await given;
      else {
        result = given;
        // Without it, the browser waits for the page to finish the transaction, which takes longer and is lost more often.
        transaction.commit();
      }
    } catch (error) {
      try {
        transaction.abort();
      } catch {
        // it has ended already
      }
      throw error;
    }
    await end;
    return result;
  };
  let reopening: Promise<IDBDatabase> | null = null;
  const again = async <T>(error: unknown, mode: IDBTransactionMode, work: Work<T>): Promise<T> => {
    if (!(error instanceof DOMException) || error.name !== 'InvalidStateError') throw error;
    reopening ??= open();
    try {
      database = await reopening;
    } finally {
      reopening = null;
    }
    return run(mode, work, true);
  };
  return {
    within: (mode, work) => inTime(run(mode, work, false).catch((error) => again(error, mode, work))),
  };
}
