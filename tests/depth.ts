import { propertySettings } from './property-settings.ts';

const { runs } = propertySettings(process.env);

/** Whether this is the deep set, which tries every case where the quick one tries a sample: see CONTRIBUTING.md. */
export const isDeep = runs >= 1;

/** Whether this is a hunt for bugs, as in `npm run bench -- soak`, which tries more than any set. */
export const isHunt = runs >= 10;
