// Imports with `.js`, as Node wants them.
export default {
  input: process.env.OPENAPI,
  output: { path: 'client', importFileExtension: '.js' },
  plugins: ['@hey-api/client-fetch'],
};
