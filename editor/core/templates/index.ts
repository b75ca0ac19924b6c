export { TEMPLATES, type Template } from './templates.ts';

/** The shipped levels, loaded on demand. */
export const loadSamples = async () => (await import('./samples.ts')).SAMPLES;
