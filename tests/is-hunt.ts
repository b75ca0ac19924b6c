import { propertySettings } from './property-settings.ts';

/** Whether this is a hunt for bugs, as in `npm run bench -- soak`, which tries every case and not a sample of them. */
export const isHunt = propertySettings(process.env).runs >= 10;
