/** Whether keys are written the way a Mac does. */
export const IS_MAC = /Mac|iP(hone|ad|od)/.test(navigator.userAgent);
