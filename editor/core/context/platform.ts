/** Whether keys are written as on a Mac. */
export const IS_MAC = /Mac|iP(hone|ad|od)/.test(globalThis.navigator?.userAgent ?? '');
